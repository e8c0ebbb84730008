#pragma once

#include "reports/ink.h"
#include "reports/layout.h"

namespace pendular {

/// Returns the colour, width and dashes that follow from `colour`, `weight` and `style`.
Pen pen_of(const Curve& curve);
/// Line style of references. Its colour is empty, since each reference has its own.
inline const Pen reference_pen{.colour = {}, .width = 1.4, .dash = "(7,4)"};
constexpr double band_opacity = 0.16;  ///< opacity of bands of standard errors

/// Returns what is drawn above axes and lines: error bars, symbols, bars, cells, names along axes
/// and keys.
/// @param page layout of this figure (`page_of`)
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
