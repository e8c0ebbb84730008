#pragma once

#include <vector>

#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns the figures of `pendular compare`: dry readings, wet readings, predicted against
/// measured values (`parity`), residuals, contributions to chi2, and fitted parameters. A reading
/// is the measured shear stress and solid fraction at one condition. The predictions are those of
/// the fitted model with all effects that the study lists.
std::vector<Figure> comparison_figures(const StudyModel& model, const Calibration& calibration,
                                       const Comparison& comparison);

}  // namespace pendular
