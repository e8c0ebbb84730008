#pragma once

#include <array>
#include <string_view>
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

// Code of the symbols in figures: the shape shows the friction coefficient, colour and filling show
// the liquid content. Source: Badetti et al. (2018), Table 2.

/// Shape for one friction coefficient.
struct FrictionCode {
    double friction;  ///< intergranular friction coefficient [1]
    Shape shape;
};
inline constexpr std::array<FrictionCode, 5> friction_code = {{{0.05, Shape::square},
                                                               {0.09, Shape::triangle},
                                                               {0.15, Shape::circle},
                                                               {0.20, Shape::star},
                                                               {0.25, Shape::downward_triangle}}};

/// Colour and filling for one liquid content.
struct ContentCode {
    double liquid_content;  ///< liquid volume divided by solid volume, Phi_L/Phi_S [1]
    std::string_view colour;
    Filling filling;
};
inline constexpr std::array<ContentCode, 5> content_code = {
    {{0.003, "#d62728", Filling::filled},       // red
     {0.007, "#1f4fd8", Filling::bottom_half},  // blue
     {0.014, "#149339", Filling::hollow},       // green
     {0.030, "#111111", Filling::crossed},      // black
     {0.063, "#8e2fb5", Filling::top_half}}};   // purple

/// Dry readings are grey. Badetti et al. (2018) state no symbols for dry grains.
inline constexpr ContentCode dry_code{0, "#808080", Filling::filled};

/// Returns the shape of the nearest friction coefficient [1] in `friction_code`.
Shape shape_of(double friction);

/// Returns the entry of `content_code` with the nearest logarithm of the liquid content [1], or
/// `dry_code` for 0.
const ContentCode& code_of(double liquid_content);

/// Returns the symbol of a simulated or predicted state.
Symbol simulated_symbol(double friction, double liquid_content);

/// Measured points are pluses, since the friction coefficient of their grains is not known.
inline constexpr Symbol measured_symbol{Shape::plus, Filling::hollow};

}  // namespace pendular
