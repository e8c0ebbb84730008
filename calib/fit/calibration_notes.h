#pragma once

#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "calib/model/run_planner.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Notes for the user of a calibration: on readings whose predictions the runs do not support, on
/// errors dominated by simulation, on wet readings at low reduced pressures, at which shear may be
/// in bands, on parameters at a bound or undetermined, and the planner's notes.
/// @param wet_known whether the noise of the wet runs is small compared with the errors of the wet
///         readings that were not fitted
std::vector<std::string> notes_on(const Calibration& calibration, const ResolvedStudy& study,
                                  const RunPlanner& planner, bool wet_known);

}  // namespace pendular
