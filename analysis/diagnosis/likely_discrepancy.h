#pragma once

#include <vector>

#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Returns the most likely size of a model's discrepancy (error that varies smoothly between
/// conditions), relative to the shear stress [1], given the residuals of the model's fit to
/// readings. The size is 0 if the discrepancy is not significant (p > 0.05). Sizes from 0.05 % to
/// 17 % are compared. The discrepancy has the correlation `discrepancy_correlation` between
/// conditions and adds to the errors of measurement and prediction. The restricted likelihood
/// allows for the fitted parameters.
/// @param measured readings, followed by direct measurements
/// @param prediction prediction of `measured` at the fitted parameters, with derivatives
/// @param conditions conditions of the readings
/// Source: Patterson and Thompson, Biometrika 58 (1971) 545.
double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions);

}  // namespace pendular
