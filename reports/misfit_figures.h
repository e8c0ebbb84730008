#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures of the misfit between readings and a model:
/// - `qq`: ordered residuals, decorrelated and in standard errors [1], against the quantiles of a
///   normal distribution; left out for fewer than three readings.
/// - `chi2_ledger`: contributions to chi2 per measured value [1], beside the expected value 1: of
///   shear stress and solid fraction, of up to six files and of up to ten conditions, the largest
///   first.
std::vector<Figure> misfit_figures(const Comparison& comparison);

}  // namespace pendular
