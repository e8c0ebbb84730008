#pragma once

#include <vector>

namespace pendular {

/// Point of a drawing: on a page [inch], or in units of sqrt(area) for a symbol of area 1. The
/// coordinate y grows upwards.
struct PaperPoint {
    double x = 0, y = 0;
};
/// Points of a drawing that are joined by straight lines in their order.
using Outline = std::vector<PaperPoint>;

enum class Shape { square, triangle, circle, star, downward_triangle, diamond, plus };

/// Filling of the inside of a symbol in a figure. `bottom_half` and `top_half` fill the lower and
/// the upper half of the symbol's height. A plus has no inside.
enum class Filling { filled, bottom_half, hollow, crossed, top_half };

/// Symbol with which a figure draws the points of a curve, in the curve's colour.
struct Symbol {
    Shape shape = Shape::circle;
    Filling filling = Filling::filled;

    bool operator==(const Symbol&) const = default;
};

/// Outlines that draw one symbol of area 1 with its centre of area at the origin.
struct SymbolDrawing {
    /// Outlines of the filled areas of the symbol; the last point of each repeats the first.
    std::vector<Outline> fills;
    /// Lines of the symbol, among them its closed edge.
    std::vector<Outline> strokes;
};

/// Returns the outlines of a symbol of area 1, so that symbols of all shapes look equally large.
/// The strokes of a plus are longer than any other symbol.
SymbolDrawing drawing_of(const Symbol& symbol);

}  // namespace pendular
