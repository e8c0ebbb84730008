#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "reports/figure.h"

namespace pendular {

/// Normalised residuals against everything that was varied, and their map: by condition, over
/// normal stress and inertial number, a panel for each liquid content and observable.
std::vector<Figure> residual_figures(const Comparison& comparison);

}  // namespace pendular
