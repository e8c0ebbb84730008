#pragma once

#include <string>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Tests for a wobble (periodic part of torque, normal force or gap at one or two periods per turn)
/// in the steady part of each step, one entry for each test.
std::vector<RecordingFinding> wobble_tests(const std::string& file,
                                           const std::vector<RecordedStep>& steps);

}  // namespace pendular
