#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// Returns two figures of the dry readings of a study. Returns an empty list if the study has no
/// dry readings. A reading is the measured shear stress and solid fraction at one condition.
/// - `calibration`: stress ratio and solid fraction against the friction coefficient, for the
///   readings at the lowest inertial number. The curve is the prediction of the fitted model
///   without effects on the instrument (such as a torque offset). The band is the mean of these
///   readings with its standard error. Each reading has been corrected to one condition and for
///   effects on the instrument, by the difference that the fitted model predicts. Curve and band
///   cross at the friction coefficient that these readings alone would give.
/// Source: Badetti et al. (2018), the calibration figure.
/// - `inertial_number`: stress ratio and solid fraction against the inertial number, as measured
///   and as predicted by the fitted model with all effects of the study. If the predictions differ
///   between normal stresses, masses of beads or files, the figure has one curve for each normal
///   stress, mass or file, and the prediction of each reading.
std::vector<Figure> dry_figures(const StudyModel& model, const Calibration& calibration);

}  // namespace pendular
