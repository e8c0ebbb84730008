#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures of the dry readings of a study. Returns an empty list if the study has no
/// dry readings. A reading is the measured shear stress and solid fraction at one condition.
/// - `calibration`: stress ratio and solid fraction against the friction coefficient. The curve is
///   the fitted model without effects on the instrument (such as a torque offset). The band is the
///   mean of the readings at the lowest inertial number, with its standard error, corrected for
///   effects on the instrument. Curve and band cross at the friction coefficient that these
///   readings alone would give.
/// - `inertial_number`: stress ratio and solid fraction against the inertial number, as measured
///   and as predicted by the fitted model with all effects of the study. If the predictions differ
///   between normal stresses, masses of beads or files, each normal stress, mass or file has a
///   curve of its own.
/// Source: Badetti et al. (2018), the calibration figure, for `calibration`.
std::vector<Figure> dry_figures(const StudyModel& model, const Calibration& calibration);

}  // namespace pendular
