#pragma once

#include <string>
#include <vector>

#include "reports/symbol.h"

namespace pendular {

/// Style of a drawn line.
struct Pen {
    std::string colour;
    double width = 1;            ///< in gnuplot's units
    std::string dash = "solid";  ///< gnuplot dash type
};

/// Shapes and text placed in inches on a page, as commands for gnuplot. They use plot styles rather
/// than gnuplot's objects, whose borders appear twice in SVG, once in black.
class Ink {
  public:
    void line(Outline points, const Pen& pen);
    /// `opacity` from 0 to 1.
    void area(Outline closed, const std::string& colour, double opacity = 1);
    /// Text beside a point, vertically centred on it.
    void text(const std::string& text, PaperPoint place, bool end_there);
    /// Text centred on a point.
    void centred(const std::string& text, PaperPoint place);
    /// A symbol of a given area [inch^2] at a place.
    void symbol(const Symbol& symbol, PaperPoint place, double area, const std::string& colour);

    /// Named data blocks, to be given once.
    std::string data_blocks() const;
    /// Draws everything on a page of this size [inch].
    std::string script(double width, double height) const;

  private:
    struct Layer {
        std::string style;  ///< gnuplot's plot style and its options
        std::vector<Outline> pieces;
    };
    void add(const std::string& style, Outline points);
    void label(const std::string& text, PaperPoint place, const char* alignment);

    std::vector<Layer> layers_;  ///< later ones lie above
    std::vector<std::string> labels_;
};

}  // namespace pendular
