#pragma once

#include <string>
#include <vector>

#include "calib/fit/fit.h"

namespace pendular {

/// Returns one sentence, with advice, for each combination of fitted parameters that the readings
/// do not determine: along the combination, the standard error exceeds the range of the parameters.
/// The combinations are principal axes of Fit::covariance in units of the parameters' ranges.
std::vector<std::string> undetermined(const Fit& fit, const std::vector<Parameter>& parameters);

}  // namespace pendular
