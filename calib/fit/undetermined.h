#pragma once

#include <string>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Returns a sentence with advice for each combination of fitted parameters that the readings do
/// not determine. A combination is undetermined if the standard error along the combination exceeds
/// the range of the parameters. The combinations are the principal axes of Fit::covariance in units
/// of the parameters' ranges. The list is empty if the readings determine all parameters.
std::vector<std::string> undetermined(const Fit& fit, const std::vector<Parameter>& parameters);

}  // namespace pendular
