#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures of the dry readings; none if the study has no dry readings.
/// - `calibration`: stress ratio and solid fraction against friction. The curve is the fitted model
///   without effects on the instrument. The band is the mean of the readings at the lowest inertial
///   number with its standard error, corrected for these effects. Curve and band cross at the
///   friction that these readings alone would give. Source: the calibration figure of Badetti et
///   al. (2018).
/// - `inertial_number`: measured and predicted values against the inertial number. If the
///   predictions differ between normal stresses, masses of beads or files, each has its own curve.
std::vector<Figure> dry_figures(const StudyModel& model, const Calibration& calibration);

}  // namespace pendular
