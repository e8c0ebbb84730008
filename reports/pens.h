#pragma once

#include "reports/figure.h"
#include "reports/ink.h"

namespace pendular {

/// Returns the colour, width and dashes that follow from `colour`, `weight` and `style`.
Pen pen_of(const Curve& curve);
/// Line style of references. Its colour is empty, since each reference has its own.
inline const Pen reference_pen{.colour = {}, .width = 1.4, .dash = "(7,4)"};
constexpr double band_opacity = 0.2;       ///< opacity of bands of standard errors
constexpr double bar_opacity = 0.55;       ///< of bars
constexpr double symbol_area = 0.1 * 0.1;  ///< usual area of symbols [inch^2]

}  // namespace pendular
