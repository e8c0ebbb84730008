#pragma once

#include <string>

#include "reports/layout.h"

namespace pendular {

/// Distance of the tics of a linear axis of this width [inch], so that their numbers do not touch.
double step_of_tics(AxisRange range, double width);

/// List of tics for a logarithmic axis of this width [inch], as gnuplot reads it: the first of
/// several series of digits times powers of ten that has four tics (if none has, three) with
/// numbers that do not touch. Where no series has, round numbers at even distances.
std::string tics_of_logarithm(AxisRange range, double width);

}  // namespace pendular
