#pragma once

#include "reports/ink.h"
#include "reports/layout.h"

namespace pendular {

/// Returns the pen for a curve that is drawn as a line: its colour, with width and dashes by the
/// curve's style and weight.
Pen pen_of(const Curve& curve);
/// Pen for reference lines, the straight lines across a panel at one value; each line has its own
/// colour.
inline const Pen reference_pen{.colour = {}, .width = 1.4, .dash = "(7,4)"};
/// Opacity with which figures draw bands of standard errors, from 0 to 1.
constexpr double band_opacity = 0.16;

/// Returns the parts of a figure that are drawn above its axes and lines: error bars, symbols,
/// bars, names along the x axes, and keys. `page`: layout of this figure by `page_of`.
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
