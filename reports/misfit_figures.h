#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures that show how a model misses the readings: `qq`, the ordered residuals against
/// the quantiles of a normal distribution (from three readings on), and `chi2_ledger`, the parts of
/// chi2 from shear stress and solid fraction, from files and from conditions, beside the parts that
/// a correct model leaves.
std::vector<Figure> misfit_figures(const Comparison& comparison);

}  // namespace pendular
