#pragma once

#include <string>
#include <vector>

#include "reports/symbol.h"

namespace pendular {

/// Style of a line that gnuplot draws in a figure.
struct Pen {
    std::string colour;
    /// Width of the line, in gnuplot's unit of line widths.
    double width = 1;
    /// Dashes of the line in gnuplot's syntax, such as "(7,4)".
    std::string dash = "solid";
};

/// Collection of shapes and texts of a figure, each at a place on the page in inches from the
/// page's lower left corner. `Ink` writes the shapes and texts as gnuplot commands. The commands
/// use plot styles rather than gnuplot's objects, whose borders appear twice in SVG, once in black.
class Ink {
  public:
    /// Adds a line through points on the page [inch].
    void line(Outline points, const Pen& pen);
    /// Adds a filled area without a border, inside a closed outline [inch].
    /// @param opacity opacity of the filling, from 0 (invisible) to 1
    void area(Outline closed, const std::string& colour, double opacity = 1);
    /// Adds a text to the left or right of a point on the page, centred vertically on the point.
    /// @param place point on the page [inch]
    /// @param end_there whether the text ends at the point; otherwise the text begins at the point
    void text(const std::string& text, PaperPoint place, bool end_there);
    /// Adds a text whose centre is at `place`, a point on the page [inch].
    void centred(const std::string& text, PaperPoint place);
    /// Adds the symbol of a data point, with the centre of the symbol's area at `place`, a point on
    /// the page [inch].
    /// @param area area of the symbol [inch^2]
    void symbol(const Symbol& symbol, PaperPoint place, double area, const std::string& colour);

    /// Returns the gnuplot commands that define the data of all shapes. A gnuplot process needs
    /// these commands once, before the commands of `script`.
    std::string data_blocks() const;
    /// Returns the gnuplot commands that draw all shapes and texts on a page of the given width and
    /// height [inch].
    std::string script(double width, double height) const;

  private:
    /// Shapes of the figure that have one plot style, drawn by one element of a gnuplot `plot`
    /// command.
    struct Layer {
        /// Plot style of the layer's shapes, with options, in gnuplot's syntax.
        std::string style;
        std::vector<Outline> pieces;
    };
    void add(const std::string& style, Outline points);
    void label(const std::string& text, PaperPoint place, const char* alignment);

    /// Shapes of the figure in the order of drawing: a later shape covers an earlier shape.
    std::vector<Layer> layers_;
    std::vector<std::string> labels_;
};

}  // namespace pendular
