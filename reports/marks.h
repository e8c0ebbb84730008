#pragma once

#include "reports/ink.h"
#include "reports/layout.h"

namespace pendular {

/// Pen for a curve that is drawn as a line, by its style, colour and weight.
Pen pen_of(const Curve& curve);
/// Pen for reference lines, without a colour.
inline const Pen reference_pen{.colour = {}, .width = 1.4, .dash = "(7,4)"};
/// Opacity of bands of errors, from 0 to 1.
constexpr double band_opacity = 0.16;

/// Draws what lies above the axes and lines of a figure: error bars, symbols, bars, names along the
/// x axes, and keys.
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
