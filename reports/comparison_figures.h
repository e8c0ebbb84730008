#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of `pendular compare`: dry readings (dry_figures.h), wet readings
/// (wet_figures.h), predicted against measured values (`parity`), residuals (residual_figures.h and
/// misfit_figures.h), and the parameters (parameter_figures.h). The figures show the fitted model
/// with all effects that the study lists.
std::vector<Figure> comparison_figures(const StudyModel& model, const Calibration& calibration,
                                       const Comparison& comparison);

}  // namespace pendular
