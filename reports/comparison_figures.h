#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// The figures of `compare`: those of dry readings (dry_figures.h) and of wet ones (wet_figures.h),
/// parity, and residuals (residual_figures.h). What they draw as the model is the fitted one, as
/// the instrument shows it. `cohesion` is what the calibration's cohesion lines were made with.
std::vector<Figure> comparison_figures(const StudyModel& model, const Calibration& calibration,
                                       const Comparison& comparison);

}  // namespace pendular
