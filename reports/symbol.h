#pragma once

#include <vector>

namespace pendular {

/// Point of a drawing, with y upwards: in inches on a page; in a symbol, divided by the square root
/// of the symbol's area [1].
struct PaperPoint {
    double x = 0, y = 0;
};
/// Points joined by straight lines.
using Outline = std::vector<PaperPoint>;

enum class Shape { square, triangle, circle, star, downward_triangle, diamond, plus };

/// Inside of a symbol. `bottom_half` and `top_half` are halves of its height; `crossed` draws two
/// diagonals. A plus has no inside.
enum class Filling { filled, bottom_half, hollow, crossed, top_half };

/// Symbol of the points of a curve, in its colour.
struct Symbol {
    Shape shape = Shape::circle;
    Filling filling = Filling::filled;

    bool operator==(const Symbol&) const = default;
};

/// Outlines of a symbol of area 1, with the centre of area at the origin.
struct SymbolDrawing {
    std::vector<Outline> fills;    ///< filled areas; the last point repeats the first
    std::vector<Outline> strokes;  ///< lines, among them the closed edge
};

/// Returns a symbol of area 1, so that all shapes look equally large. A plus has no area; its
/// strokes are a little longer than the reach of any symbol of area 1.
SymbolDrawing drawing_of(const Symbol& symbol);

}  // namespace pendular
