#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "reports/figure.h"

namespace pendular {

/// Figures of the residuals, (measured - predicted) over the standard error [1]:
/// - `residuals`: residual of each reading against every quantity that was varied;
/// - `residual_map`: mean residual of each condition over normal stress and inertial number, with a
///   panel for each liquid content and observable.
std::vector<Figure> residual_figures(const Comparison& comparison);

}  // namespace pendular
