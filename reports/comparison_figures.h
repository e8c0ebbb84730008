#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of `pendular compare`: dry readings (dry_figures.h), wet readings
/// (wet_figures.h), predicted against measured values (`parity`), and residuals
/// (residual_figures.h). The model in them is the fitted model with the study's effects.
std::vector<Figure> comparison_figures(const StudyModel& model, const Calibration& calibration,
                                       const Comparison& comparison);

}  // namespace pendular
