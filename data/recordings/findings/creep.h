#pragma once

#include <string>
#include <vector>

#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Finds the steps of a recording whose gap creeps while the torque is steady, and takes the steady
/// part of their torque for that of the step. One short step tells little, and one in a hundred
/// steady gaps counts as not steady by chance. A gap that is not steady therefore creeps if it
/// changes by more than 4 standard errors, if it and the gap of another such step change by more
/// than 2 in one sense, or if it changes in the sense in which the gaps of the whole recording
/// drift (`drift_tests`, p < 0.005).
void find_creep(const std::string& file, std::vector<RecordedStep>& steps);

}  // namespace pendular
