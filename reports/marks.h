#pragma once

#include "reports/ink.h"
#include "reports/layout.h"

namespace pendular {

/// How a line is drawn; no points or bands.
Pen pen_of(const Curve& curve);
inline const Pen reference_pen{.colour = {}, .width = 1.4, .dash = "(7,4)"};
constexpr double band_opacity = 0.16;

/// Elements drawn above the axes and lines of a figure: error bars, symbols, keys.
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
