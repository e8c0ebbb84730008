#pragma once

#include <vector>

#include "calib/fit/fit.h"
#include "data/reading.h"

namespace pendular {

/// Most likely size of a smooth error of the model, relative to the shear stress [1], given the
/// residuals of its fit to readings; 0 where no such error is significant (p > 0.05). The error has
/// the correlation of `discrepancy_correlation` and adds to the errors of measurement and of the
/// prediction. The restricted likelihood allows for the fitted parameters. Source: Patterson and
/// Thompson, Biometrika 58 (1971) 545.
/// @param prediction prediction of the readings, and of direct measurements after them, at the
///        fitted parameters, with derivatives
double likely_discrepancy(const Measured& measured, const Prediction& prediction,
                          const std::vector<Condition>& conditions);

}  // namespace pendular
