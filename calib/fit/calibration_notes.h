#pragma once

#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "calib/model/run_planner.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Returns sentences for the user that qualify the result of a calibration. The sentences name
/// readings whose predictions the runs do not support, predictions whose simulation noise exceeds
/// the errors of the readings, a large contribution of corrections to the error of the friction
/// coefficient, wet readings at reduced pressures so low that the grains may shear in bands, and
/// parameters that are undetermined or at a bound. A sentence also tells whether the time for
/// simulations ended too early. The notes of `planner` on runs are included.
/// @param wet_known whether the standard errors of the predicted wet readings are small compared
///        with the standard errors of the measured wet readings
std::vector<std::string> notes_on(const Calibration& calibration, const ResolvedStudy& study,
                                  const RunPlanner& planner, bool wet_known);

}  // namespace pendular
