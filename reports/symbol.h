#pragma once

#include <vector>

namespace pendular {

/// Point of a drawing, with y upwards. The coordinates of a point on a page are in inches. The
/// coordinates of a point of a symbol are divided by the square root of the symbol's area [1].
struct PaperPoint {
    double x = 0, y = 0;
};
/// Polyline of a drawing: consecutive points are joined by straight lines.
using Outline = std::vector<PaperPoint>;

enum class Shape { square, triangle, circle, star, downward_triangle, diamond, plus };

/// Filling of the inside of a symbol in a figure. `bottom_half` and `top_half` fill the lower and
/// the upper half of the symbol's height. `crossed` draws two diagonal lines. A plus has no inside.
enum class Filling { filled, bottom_half, hollow, crossed, top_half };

/// Symbol with which a figure draws the points of a curve, in the curve's colour.
struct Symbol {
    Shape shape = Shape::circle;
    Filling filling = Filling::filled;

    bool operator==(const Symbol&) const = default;
};

/// Outlines that draw one symbol of area 1, with the centre of area at the origin.
struct SymbolDrawing {
    /// Outlines of the filled areas of the symbol. The last point of each outline repeats the first
    /// point.
    std::vector<Outline> fills;
    /// Lines of the symbol, among them the closed edge of the symbol.
    std::vector<Outline> strokes;
};

/// Returns the outlines of a symbol of area 1, so that symbols of all shapes look equally large. A
/// plus has no area; its strokes are a little longer than the reach of any symbol of area 1.
SymbolDrawing drawing_of(const Symbol& symbol);

}  // namespace pendular
