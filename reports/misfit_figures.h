#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures of the misfit between readings (measured shear stress and solid fraction) and a
/// model:
/// - `qq`: ordered residuals, decorrelated and in standard errors [1], against the quantiles of a
///   normal distribution. The figure is left out for fewer than three readings.
/// - `chi2_ledger`: contributions to chi2 per measured value [1], beside the value 1 that is
///   expected for a correct model. The contributions come from shear stress and solid fraction,
///   from up to six files and from up to ten conditions, the largest first.
std::vector<Figure> misfit_figures(const Comparison& comparison);

}  // namespace pendular
