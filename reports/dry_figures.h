#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures of the dry readings; none without dry readings:
/// - `calibration`: stress ratio and solid fraction against friction, for the readings at the
///   lowest inertial number. The curve is the model's prediction without effects on the instrument,
///   at the fitted parameters. The measured band is corrected for effects on the instrument, by the
///   change that the fitted model predicts for each reading. Curve and band cross at the friction
///   that these readings alone would give. Source: Badetti et al. (2018), the calibration figure.
/// - `inertial_number`: stress ratio and solid fraction against the inertial number: readings as
///   measured, and the fitted model with all effects of the study. Where the predictions differ
///   between normal stresses, masses of beads or files, the model has a curve for each, with the
///   prediction of each reading.
std::vector<Figure> dry_figures(const StudyModel& model, const Calibration& calibration);

}  // namespace pendular
