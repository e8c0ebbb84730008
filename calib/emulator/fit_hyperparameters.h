#pragma once

#include "calib/emulator/gaussian_process.h"
#include "calib/emulator/kernel.h"

namespace pendular {

/// Fits the hyperparameters of the Gaussian process of one quantity, the first of `known`: they
/// maximise likelihood times prior, found by Ceres with analytic gradients. Broad log-normal priors
/// keep hyperparameters finite that the observations do not determine.
/// @param unit typical size of the quantity, in its unit
/// @throws std::invalid_argument where `known` has no observation
Hyperparameters fit_hyperparameters(Domain domain, const Observations& known, double unit);

/// Returns the function that `fit_hyperparameters` minimises, -ln(likelihood) - ln(prior) up to a
/// constant; infinite where the covariance of the observations is not positive definite.
/// @param unit typical size of the quantity, in its unit
/// @param gradient receives the derivatives of the returned value by the logarithms of the
///         hyperparameters, in the order of `Hyperparameters::names`; may be null
double hyperparameter_cost(Domain domain, const Observations& known, double unit,
                           const Hyperparameters& hyperparameters, double* gradient);

}  // namespace pendular
