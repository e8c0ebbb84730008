#pragma once

#include <string>

#include "reports/figure.h"

namespace pendular {

/// Returns the numbers of a figure as CSV (RFC 4180), one row per point and per reference line. The
/// first five columns are the number of the panel from 1, the label of the curve, x, y and the
/// standard error of y (for a vertical reference line: of x). The sixth column is the name at x if
/// the axis shows names in place of numbers. The seventh and eighth columns are the labels of the x
/// axis and of the y axis with their units. A figure with names along y has the further column
/// y_name. A figure with cells has the further column value, the strength of the colour of each
/// cell. A name on the x axis at which no curve has a point has a row of its own, without y.
std::string numbers_table(const Figure& figure);

}  // namespace pendular
