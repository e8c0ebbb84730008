#pragma once

#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "calib/model/run_planner.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Returns sentences for the user that qualify the result of a calibration. The sentences report
/// - readings whose predictions the runs do not support,
/// - simulation noise that exceeds the errors of the readings,
/// - time for simulations that ended too early,
/// - a large contribution of corrections to the error of the friction coefficient,
/// - wet readings at reduced pressures so low that the grains may shear in bands, and
/// - parameters that are undetermined or at a bound.
///
/// The notes of `planner` on runs are included.
/// @param wet_known whether the standard errors of the predicted wet readings are small compared
///        with the standard errors of the measured wet readings
std::vector<std::string> notes_on(const Calibration& calibration, const ResolvedStudy& study,
                                  const RunPlanner& planner, bool wet_known);

}  // namespace pendular
