#pragma once

#include <string>

#include "reports/figure.h"

namespace pendular {

/// The numbers of a figure as CSV (RFC 4180), a row for each point and reference: number of the
/// panel from 1, name of the curve, x, y, standard error of y (of a vertical reference: of x), what
/// stands at x in place of a number, and what the axes say with their units. Names without any
/// point have a row of their own.
std::string numbers_table(const Figure& figure);

}  // namespace pendular
