#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "reports/figure.h"

namespace pendular {

/// Returns figures of the residuals, (measured - predicted)/(standard error of the difference) [1]:
/// - `residuals`: of shear stress and solid fraction of each reading, in one panel for each
///   quantity that varies between the readings
/// - `residual_map`: mean residual of each condition, in standard errors of the mean [1], in the
///   plane of normal stress and inertial number, with one panel for each liquid content and
///   observable; left out if all readings have one inertial number
std::vector<Figure> residual_figures(const Comparison& comparison);

}  // namespace pendular
