#pragma once

#include <array>
#include <string_view>

#include "reports/symbol.h"

namespace pendular {

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
