#pragma once

#include <string>
#include <vector>

#include "data/recordings/findings/recorded_step.h"
#include "data/remarks/remark.h"

namespace pendular {

/// Tests torque, normal force and gap in the `level_part` of each step for one or two periods per
/// turn of the lid. Returns one entry for each test, significant or not.
std::vector<Remark> wobble_tests(const std::string& file, const std::vector<RecordedStep>& steps);

}  // namespace pendular
