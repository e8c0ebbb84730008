#pragma once

#include <vector>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "reports/figure.h"

namespace pendular {

/// The figures of dry readings, none where there are none:
/// - `calibration`: stress ratio and solid fraction against friction, of the readings at the lowest
///   inertial number. The curve is the flow of the grains, before the instrument shows it; where
/// the study has
///   effects on the instrument, the measured band is corrected for them, by what the fitted model
///   says of each reading. They cross where these readings alone would put the friction. Source:
///   Badetti et al. (2018), the calibration figure.
/// - `inertial_number`: both against the inertial number as the instrument shows them: readings as
///   they were measured, the fitted model with all its effects. Where what is shown depends on
///   normal stress, mass of beads or file, each has a curve of its own, and the prediction of every
///   reading stands beside it.
std::vector<Figure> dry_figures(const StudyModel& model, const Calibration& calibration);

}  // namespace pendular
