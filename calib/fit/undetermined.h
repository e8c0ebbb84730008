#pragma once

#include <string>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Returns a sentence with advice for each combination of fitted parameters that the readings do
/// not determine. The combinations are the principal axes of the covariance of the parameters,
/// after each parameter is divided by the width of its range. A combination is undetermined if its
/// standard error in these units exceeds 1.
std::vector<std::string> undetermined(const Fit& fit, const std::vector<Parameter>& parameters);

}  // namespace pendular
