#pragma once

#include <string>

#include "reports/figure.h"

namespace pendular {

/// Returns the numbers of a figure as CSV (RFC 4180), one row per point and per reference line.
/// Columns: panel (from 1), curve (label), x, y, y_error (for a vertical reference line: of x),
/// x_name (in place of numbers), x_label, y_label; y_name and value (strength of a cell's colour)
/// only in figures that have them. A name on the x axis without any point has a row without y.
std::string numbers_table(const Figure& figure);

}  // namespace pendular
