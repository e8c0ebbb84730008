#pragma once

#include <vector>

#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Returns the most likely relative error [1] of a model's shear stress (discrepancy), from the
/// residuals of its fit: the size between 0.05 % and 17 % with the largest restricted likelihood,
/// or 0 if it is not significant (p > 0.05). Errors at two conditions have the correlation
/// `discrepancy_correlation`.
/// @param conditions conditions of the readings, which come first in `measured`
/// Source: Patterson and Thompson, Biometrika 58 (1971) 545.
double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions);

}  // namespace pendular
