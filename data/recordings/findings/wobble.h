#pragma once

#include <string>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Tests torque, normal force and gap in each step for a wobble: a periodic variation with one or
/// two periods per turn of the lid. The test uses the part of the step after the transient or, if
/// the step never becomes steady, the second half of the step. Returns one entry for each test,
/// significant or not.
/// @param file path of the recording
std::vector<RecordingFinding> wobble_tests(const std::string& file,
                                           const std::vector<RecordedStep>& steps);

}  // namespace pendular
