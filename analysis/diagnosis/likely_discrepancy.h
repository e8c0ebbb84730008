#pragma once

#include <vector>

#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Returns the most likely relative size [1] of the error of a model's shear stress (discrepancy),
/// from the residuals of the model's fit to readings. The error varies smoothly between conditions,
/// with the correlation `discrepancy_correlation`. The result is the size between 0.05 % and 17 %
/// with the largest restricted likelihood, or 0 if the discrepancy is not significant (p > 0.05).
/// @param measured values of the readings, followed by direct measurements of effects' parameters
/// @param prediction prediction of `measured` at the fitted parameters, with derivatives and with
///        the covariance of the simulation's errors
/// @param conditions conditions of the readings
/// Source: Patterson and Thompson, Biometrika 58 (1971) 545.
double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions);

}  // namespace pendular
