#pragma once

#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "calib/model/run_planner.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Returns sentences for the user that qualify the result of a calibration. The sentences report
/// - readings whose predictions the simulation runs do not support,
/// - simulation noise that exceeds the errors of the readings,
/// - time for simulations that ended before their noise was small enough,
/// - a large error of the friction coefficient from corrections to the stiffness of the grains and
///   to the quasi-static limit,
/// - wet readings at reduced pressures so low that the grains may shear in bands, and
/// - parameters that are undetermined or at a bound.
///
/// The notes of `planner` on simulation runs (RunPlanner::notes()) are included.
/// @param wet_known whether the errors that the noise of the simulation runs causes in the
///        predicted wet readings are small compared with the errors of the measured wet readings
std::vector<std::string> notes_on(const Calibration& calibration, const ResolvedStudy& study,
                                  const RunPlanner& planner, bool wet_known);

}  // namespace pendular
