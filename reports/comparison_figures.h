#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of `pendular compare`: dry readings, wet readings, predicted against
/// measured values (`parity`), residuals, contributions to chi2, and fitted parameters. The
/// predictions are those of the fitted model with all effects of the study.
std::vector<Figure> comparison_figures(const StudyModel& model, const Calibration& calibration,
                                       const Comparison& comparison);

}  // namespace pendular
