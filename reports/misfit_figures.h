#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures that show how a model misses the readings: `qq`, the ordered residuals against
/// the quantiles of a normal distribution (from three readings on), and `chi2_ledger`, the
/// contributions to chi2 [1] of shear stress and solid fraction, of files and of conditions, beside
/// the contributions that are expected if the model is correct.
std::vector<Figure> misfit_figures(const Comparison& comparison);

}  // namespace pendular
