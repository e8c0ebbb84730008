#pragma once

#include "calib/emulator/gaussian_process.h"
#include "calib/emulator/kernel.h"

namespace pendular {

/// Scales of greatest likelihood for one quantity, by Ceres with analytic gradients; broad
/// log-normal priors keep those finite of which the observations say nothing.
/// @param unit typical size of the quantity
/// @throws std::invalid_argument where no place is known
Scales learn_scales(Domain domain, const Observations& known, double unit);

/// What that minimises, -ln(likelihood) - ln(prior) up to a constant, with its derivatives by the
/// logarithms of the scales in the order of `Scales::names`.
double scales_cost(Domain domain, const Observations& known, double unit, const Scales& scales,
                   double* gradient);

}  // namespace pendular
