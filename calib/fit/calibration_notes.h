#pragma once

#include <string>
#include <vector>

#include "calib/fit/calibration.h"
#include "calib/model/run_planner.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Lines that the user of a calibration should read: readings that the runs do not support, errors
/// that simulation dominates, parameters at a bound or undetermined.
/// @param wet_known whether the wet runs are sharp beside the wet readings
std::vector<std::string> notes_on(const Calibration& calibration, const ResolvedStudy& study,
                                  const RunPlanner& planner, bool wet_known);

}  // namespace pendular
