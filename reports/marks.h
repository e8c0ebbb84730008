#pragma once

#include "reports/ink.h"
#include "reports/layout.h"

namespace pendular {

/// Returns the line style for drawing a curve: the colour of the curve, and width and dashes by its
/// `style` and `weight`.
Pen pen_of(const Curve& curve);
/// Line style of reference lines, the straight lines across a panel at one value. The colour is
/// empty, since each reference line has its own.
inline const Pen reference_pen{.colour = {}, .width = 1.4, .dash = "(7,4)"};
/// Opacity with which figures draw bands of standard errors, from 0 to 1.
constexpr double band_opacity = 0.16;

/// Returns the parts of a figure that are drawn above its axes and lines: error bars, symbols,
/// bars, names along the x axes, and keys.
/// @param page layout of this figure, by `page_of`
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
