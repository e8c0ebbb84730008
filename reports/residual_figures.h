#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures of the residuals of a fit. A residual is measured minus predicted value, divided
/// by the standard error [1].
/// - `residuals`: residuals of shear stress and solid fraction of each reading, in one panel for
///   each quantity that varies between the readings;
/// - `residual_map`: mean residual of each condition in the plane of normal stress and inertial
///   number, with one panel for each liquid content, for shear stress and for solid fraction.
std::vector<Figure> residual_figures(const Comparison& comparison);

}  // namespace pendular
