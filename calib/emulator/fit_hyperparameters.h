#pragma once

#include "calib/emulator/gaussian_process.h"
#include "calib/emulator/kernel.h"

namespace pendular {

/// Returns the hyperparameters of the Gaussian process of one quantity that maximise the product of
/// likelihood and prior. Broad log-normal priors keep undetermined hyperparameters finite.
/// @param known observations; only the first column of `known.values` is used
/// @param unit typical size of the quantity, in the unit of the quantity
/// @throws std::invalid_argument if `known` has no observation
Hyperparameters fit_hyperparameters(Domain domain, const Observations& known, double unit);

/// Returns the cost that `fit_hyperparameters` minimises [1]: -ln(likelihood) - ln(prior), up to a
/// constant; infinite if the covariance of the observations is not positive definite.
/// @param gradient receives the derivatives of the cost with respect to the logarithms of the
///        hyperparameters, in the order of `Hyperparameters::names`; may be null
double hyperparameter_cost(Domain domain, const Observations& known, double unit,
                           const Hyperparameters& hyperparameters, double* gradient);

}  // namespace pendular
