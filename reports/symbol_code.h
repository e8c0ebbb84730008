#pragma once

#include <array>
#include <string_view>

#include "reports/symbol.h"

namespace pendular {

// Code of the symbols in figures: the shape shows the friction coefficient, colour and filling show
// the liquid content. Source: Badetti et al. (2018), Table 2.

/// Shape of the symbols in figures for one value of the intergranular friction coefficient.
struct FrictionCode {
    double friction;  ///< intergranular friction coefficient [1]
    Shape shape;
};
inline constexpr std::array<FrictionCode, 5> friction_code = {{{0.05, Shape::square},
                                                               {0.09, Shape::triangle},
                                                               {0.15, Shape::circle},
                                                               {0.20, Shape::star},
                                                               {0.25, Shape::downward_triangle}}};

/// Colour and filling of the symbols in figures for one value of the liquid content.
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

/// Colour and filling of symbols for dry readings: grey, filled. Badetti et al. (2018) state no
/// symbols for dry grains.
inline constexpr ContentCode dry_code{0, "#808080", Filling::filled};

/// Returns the shape of symbols for grains with this friction coefficient [1]. The shape belongs to
/// the nearest friction coefficient in `friction_code`.
Shape shape_of(double friction);

/// Returns the colour and filling of symbols for this liquid content [1]. Colour and filling belong
/// to the liquid content in `content_code` whose logarithm is nearest, or to `dry_code` for the
/// liquid content 0.
const ContentCode& code_of(double liquid_content);

/// Returns the symbol of a simulated or predicted state. The shape encodes the friction coefficient
/// [1]. The filling encodes the liquid content (liquid volume divided by grain volume) [1].
Symbol simulated_symbol(double friction, double liquid_content);

/// Symbol of measured points: a plus, since the friction coefficient of the measured grains is not
/// known.
inline constexpr Symbol measured_symbol{Shape::plus, Filling::hollow};

}  // namespace pendular
