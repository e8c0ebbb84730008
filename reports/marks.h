#pragma once

#include "reports/ink.h"
#include "reports/layout.h"

namespace pendular {

/// Returns the line style for drawing a curve: the colour of the curve, with the width and the
/// dashes that follow from `style` and `weight` of the curve.
Pen pen_of(const Curve& curve);
/// Line style of reference lines, the straight lines across a panel at one value. The colour is
/// empty, since each reference line has a colour of its own.
inline const Pen reference_pen{.colour = {}, .width = 1.4, .dash = "(7,4)"};
/// Opacity with which figures draw bands of standard errors, from 0 to 1.
constexpr double band_opacity = 0.16;

/// Returns the parts of a figure that are drawn above the axes and lines: error bars, symbols,
/// bars, cells, names along the axes, and keys (legends).
/// @param page layout of this figure, computed by `page_of`
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
