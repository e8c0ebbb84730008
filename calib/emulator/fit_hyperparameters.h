#pragma once

#include "calib/emulator/gaussian_process.h"
#include "calib/emulator/kernel.h"

namespace pendular {

/// Hyperparameters of greatest likelihood for one quantity, by Ceres with analytic gradients; broad
/// log-normal priors keep those finite of which the observations say nothing.
/// @param unit typical size of the quantity
/// @throws std::invalid_argument where no place is known
Hyperparameters fit_hyperparameters(Domain domain, const Observations& known, double unit);

/// Objective of the fit, -ln(likelihood) - ln(prior) up to a constant, with its derivatives by the
/// logarithms of the hyperparameters in the order of `Hyperparameters::names`.
double hyperparameter_cost(Domain domain, const Observations& known, double unit,
                           const Hyperparameters& hyperparameters, double* gradient);

}  // namespace pendular
