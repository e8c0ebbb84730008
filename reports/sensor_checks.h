#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/propose.h"
#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns a text that asks to check a sensor with known values over the range of the readings.
/// @param target "torque", "normal_force" or "height"
/// @param change proposed change of the shown quantity, which gives the error to expect; may be
///        null
/// @param too_large suggested error over the shown value [1], positive if the sensor shows too
///        much; used if `change` is null; 0: unknown
std::string sensor_check(const std::string& target, const std::vector<Reading>& readings,
                         const Study& study, const FittedShape* change = nullptr,
                         double too_large = 0);

}  // namespace pendular
