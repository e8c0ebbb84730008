#pragma once

#include <string>

#include "reports/figure.h"

namespace pendular {

/// Returns the numbers of a figure as CSV (RFC 4180), one row per point and per reference line.
/// Columns: number of the panel from 1, label of the curve, x, y, standard error of y (for a
/// vertical reference line: of x), name at x where the axis shows names in place of numbers, and
/// labels of both axes with their units. A name at which no curve has a point has a row with x
/// alone.
std::string numbers_table(const Figure& figure);

}  // namespace pendular
