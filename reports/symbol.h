#pragma once

#include <vector>

namespace pendular {

/// Point of a drawing, in the drawing's unit of length; y grows upwards.
struct PaperPoint {
    double x = 0, y = 0;
};
/// Points joined by straight lines.
using Outline = std::vector<PaperPoint>;

enum class Shape { square, triangle, circle, star, downward_triangle, diamond, plus };

/// Filling of a symbol's inside. The halves are the lower and the upper half of the height. A plus
/// has no inside.
enum class Filling { filled, bottom_half, hollow, crossed, top_half };

/// Symbol of the points of a curve. The curve has the colour.
struct Symbol {
    Shape shape = Shape::circle;
    Filling filling = Filling::filled;

    bool operator==(const Symbol&) const = default;
};

/// Outlines of a symbol whose centre of area is the origin.
struct SymbolDrawing {
    std::vector<Outline> fills;    ///< filled areas; the last point repeats the first
    std::vector<Outline> strokes;  ///< lines, among them the closed edge of the symbol
};

/// Outlines of a symbol of area 1, so that symbols of all shapes look equally large. A plus reaches
/// beyond the edges of all other symbols.
SymbolDrawing drawing_of(const Symbol& symbol);

}  // namespace pendular
