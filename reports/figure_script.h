#pragma once

#include <string>

#include "reports/figure.h"
#include "reports/ink.h"
#include "reports/layout.h"

namespace pendular {

/// Whether gnuplot draws a line or a band through the points of a curve; symbols, bars and cells
/// are `Ink`.
bool has_line(const Curve& curve);

/// Returns the part of a figure that gnuplot can draw: marks at values that are finite, and panels
/// that have an extent. Lines keep values that are not finite, as gaps.
Figure drawable(Figure figure);

/// Returns gnuplot commands that define the data of lines and bands as named blocks, once for all
/// file formats.
std::string data_blocks(const Figure& figure);

/// Returns gnuplot commands that draw a figure: axes, reference lines, lines and bands, and `marks`
/// over them.
/// @param page layout of this figure (`page_of`)
std::string script_of_page(const Figure& figure, const Page& page, const Ink& marks);

}  // namespace pendular
