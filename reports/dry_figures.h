#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures of the dry readings of a study; none where there are no dry readings:
/// - `calibration`: stress ratio and solid fraction against friction, for the readings at the
///   lowest inertial number. The curve is the model's prediction without effects on the instrument,
///   at the fitted parameters. The band is the measured value, corrected for effects on the
///   instrument by the change that the fitted model predicts for each reading. Curve and band cross
///   at the friction that these readings alone would give. Source: Badetti et al. (2018), the
///   calibration figure.
/// - `inertial_number`: stress ratio and solid fraction against the inertial number, as measured
///   and as predicted by the fitted model with all effects of the study. Where the predictions
///   differ between normal stresses, masses of beads or files, there is a curve for each of them,
///   with the prediction of each reading.
std::vector<Figure> dry_figures(const StudyModel& model, const Calibration& calibration);

}  // namespace pendular
