#pragma once

#include <vector>

#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Returns the most likely size of a model's discrepancy, relative to the shear stress [1], given
/// the residuals of the model's fit to readings. The discrepancy is an error of the model that
/// varies smoothly between conditions, with the correlation `discrepancy_correlation`. The
/// restricted likelihood selects the size among sizes from 0.05 % to 17 %. The size is 0 if the
/// discrepancy is not significant (p > 0.05).
/// @param measured readings, followed by direct measurements
/// @param prediction prediction of `measured` at the fitted parameters, with derivatives
/// @param conditions conditions of the readings
/// Source: Patterson and Thompson, Biometrika 58 (1971) 545.
double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions);

}  // namespace pendular
