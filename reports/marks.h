#pragma once

#include "reports/ink.h"
#include "reports/layout.h"

namespace pendular {

inline const std::string dotted_dash = "(1.5,2.5)", reference_dash = "(7,4)";
constexpr double line_width = 1.8, reference_width = 1.4, band_opacity = 0.16;

/// All that lies above the axes and lines of a figure: error bars, symbols, keys.
Ink marks_of(const Figure& figure, const Page& page);

}  // namespace pendular
