#pragma once

#include <string>
#include <vector>

#include "reports/symbol.h"

namespace pendular {

/// Style of a drawn line.
struct Pen {
    std::string colour;
    double width = 1;            ///< line width in gnuplot's unit
    std::string dash = "solid";  ///< gnuplot dash type
};

/// Collects shapes and texts at places on a page [inch] and writes them as gnuplot commands. The
/// commands use plot styles rather than gnuplot's objects, whose borders appear twice in SVG, once
/// in black.
class Ink {
  public:
    /// Adds a line through points.
    void line(Outline points, const Pen& pen);
    /// Adds a filled area without a border; `opacity` from 0 to 1.
    void area(Outline closed, const std::string& colour, double opacity = 1);
    /// Adds a text that begins at a place or, if `end_there`, ends at it; centred vertically.
    void text(const std::string& text, PaperPoint place, bool end_there);
    /// Adds a text centred on a place.
    void centred(const std::string& text, PaperPoint place);
    /// Adds a symbol of an area [inch^2] centred on a place.
    void symbol(const Symbol& symbol, PaperPoint place, double area, const std::string& colour);

    /// Returns the gnuplot commands that define the data of all shapes, needed once per gnuplot
    /// process, before `script`.
    std::string data_blocks() const;
    /// Returns the gnuplot commands that draw all shapes and texts on a page of this size [inch].
    std::string script(double width, double height) const;

  private:
    /// Shapes of one style.
    struct Layer {
        std::string style;  ///< gnuplot's plot style and its options
        std::vector<Outline> pieces;
    };
    void add(const std::string& style, Outline points);
    void label(const std::string& text, PaperPoint place, const char* alignment);

    std::vector<Layer> layers_;  ///< in the order of drawing; later layers cover earlier layers
    std::vector<std::string> labels_;
};

}  // namespace pendular
