#pragma once

#include <array>
#include <string_view>

#include "reports/symbol.h"

namespace pendular {

// How figures tell frictions and liquid contents apart: shape by friction, colour and filling by
// liquid content. Source: Badetti et al. (2018), tab:symbols.

struct FrictionCode {
    double friction;
    Shape shape;
};
inline constexpr std::array<FrictionCode, 5> friction_code = {{{0.05, Shape::square},
                                                               {0.09, Shape::triangle},
                                                               {0.15, Shape::circle},
                                                               {0.20, Shape::star},
                                                               {0.25, Shape::downward_triangle}}};

struct ContentCode {
    double liquid_content;  ///< Phi_L/Phi_S [1]
    std::string_view colour;
    Filling filling;
};
inline constexpr std::array<ContentCode, 5> content_code = {
    {{0.003, "#d62728", Filling::filled},       // red
     {0.007, "#1f4fd8", Filling::bottom_half},  // blue
     {0.014, "#149339", Filling::hollow},       // green
     {0.030, "#111111", Filling::crossed},      // black
     {0.063, "#8e2fb5", Filling::top_half}}};   // purple

/// Symbols of dry readings, for which Badetti et al. (2018) give no code: grey.
inline constexpr ContentCode dry_code{0, "#808080", Filling::filled};

/// Shape of the nearest friction of the code.
Shape shape_of(double friction);

/// Colour and filling of the liquid content of the code that is nearest in the logarithm, as the
/// contents of the code are about evenly spaced there; grey where dry.
const ContentCode& code_of(double liquid_content);

/// The symbol of a simulated state.
Symbol simulated_symbol(double friction, double liquid_content);

/// Measured points are plusses whatever the friction, which is not known; their colour tells the
/// liquid content.
inline constexpr Symbol measured_symbol{Shape::plus, Filling::hollow};

}  // namespace pendular
