#pragma once

#include <vector>

#include "analysis/compare.h"
#include "calib/calibration.h"
#include "reports/figure.h"

namespace pendular {

/// The figures of `compare`: stress ratio and solid fraction against friction with the measured
/// band and the calibrated value (the source's calibration figure), both against the inertial
/// number, those of wet readings (wet_figures.h), parity, and residuals (residual_figures.h).
/// `cohesion` is what the calibration's cohesion lines were made with.
std::vector<Figure> comparison_figures(const StudyModel& model, const Calibration& calibration,
                                       const Comparison& comparison);

}  // namespace pendular
