#pragma once

#include <string>
#include <vector>

#include "reports/symbol.h"

namespace pendular {

/// Style of a line.
struct Pen {
    std::string colour;
    double width = 1;            ///< in gnuplot's unit of line widths
    std::string dash = "solid";  ///< in gnuplot's syntax, such as "(7,4)"
};

/// Shapes and texts of a figure, placed in inches from the lower left corner of the page, which are
/// written as gnuplot commands. They use plot styles rather than gnuplot's objects, whose borders
/// appear twice in SVG, once in black.
class Ink {
  public:
    /// Adds a line through points on the page [inch].
    void line(Outline points, const Pen& pen);
    /// Adds a filled area without a border.
    /// @param opacity from 0 (invisible) to 1
    void area(Outline closed, const std::string& colour, double opacity = 1);
    /// Adds a text left or right of a point, centred vertically on it.
    /// @param end_there whether the text ends at the point; otherwise it begins there
    void text(const std::string& text, PaperPoint place, bool end_there);
    /// Adds a text with its centre at a point.
    void centred(const std::string& text, PaperPoint place);
    /// Adds a text in the size of titles with its centre at a point.
    void title(const std::string& text, PaperPoint place);
    /// Adds the symbol of a data point, with its centre of area at `place`.
    /// @param area [inch^2]
    void symbol(const Symbol& symbol, PaperPoint place, double area, const std::string& colour);

    /// Returns the commands that define the data of all shapes. A gnuplot process needs them once,
    /// before the commands of `script`.
    std::string data_blocks() const;
    /// Returns the commands that draw all on a page of this size [inch].
    std::string script(double width, double height) const;

  private:
    /// Shapes of one plot style, drawn by one element of a `plot` command.
    struct Layer {
        std::string style;  ///< with options, in gnuplot's syntax
        std::vector<Outline> pieces;
    };
    void add(const std::string& style, Outline points);
    void label(const std::string& text, PaperPoint place, const std::string& options);

    std::vector<Layer> layers_;  ///< in the order of drawing
    std::vector<std::string> labels_;
};

}  // namespace pendular
