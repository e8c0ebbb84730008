#pragma once

#include <string>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// A sentence for each combination of parameters that the readings do not determine: along it,
/// parameters may move by more than the whole of their ranges and the fit stays as good. The
/// combinations are principal axes of the covariance in units of those ranges.
std::vector<std::string> undetermined(const Fit& fit, const std::vector<Parameter>& parameters);

}  // namespace pendular
