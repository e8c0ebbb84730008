#pragma once

#include <vector>

namespace pendular {

/// A place on paper, in whatever unit the drawing is in; y grows upwards.
struct PaperPoint {
    double x = 0, y = 0;
};
using Outline = std::vector<PaperPoint>;

enum class Shape { square, triangle, circle, star, downward_triangle, diamond, plus };

/// How the inside of a symbol looks. A half is that of its height. A plus has no inside.
enum class Filling { filled, bottom_half, hollow, crossed, top_half };

/// Symbol of a point; its colour belongs to the curve.
struct Symbol {
    Shape shape = Shape::circle;
    Filling filling = Filling::filled;

    bool operator==(const Symbol&) const = default;
};

/// A symbol as outlines about its centre of area, which is the origin.
struct SymbolDrawing {
    std::vector<Outline> fills;    ///< closed: the last point is the first
    std::vector<Outline> strokes;  ///< lines; the edge is among them, closed
};

/// The drawing of a symbol whose edge encloses the area 1, whatever its shape, so that all symbols
/// weigh the same to the eye. A plus reaches out of all of them.
SymbolDrawing drawing_of(const Symbol& symbol);

}  // namespace pendular
