#pragma once

#include <string>

#include "reports/figure.h"

namespace pendular {

/// Returns the numbers of a figure as CSV (RFC 4180), one row per point and per reference line.
/// Columns:
/// - panel: number of the panel, from 1
/// - curve: label of the curve or reference line
/// - x, y
/// - y_error: standard error of y (for a vertical reference line: of x)
/// - x_name: name at x, if the axis shows names in place of numbers
/// - x_label, y_label: labels of the axes with their units
/// - y_name: name at y, only in a figure with names along y
/// - value: strength of the colour of a cell, only in a figure with cells
///
/// A name on the x axis at which no curve has a point has a row of its own, without y.
std::string numbers_table(const Figure& figure);

}  // namespace pendular
