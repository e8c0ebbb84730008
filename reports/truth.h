#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// JSON of the truth behind the recordings of a virtual laboratory, for users and scripts: hidden
/// friction and effects, plan, and the condition and simulation run of each step, with all that is
/// needed to repeat the run. The program never reads this file.
nlohmann::ordered_json to_json(const LabResult& result);

}  // namespace pendular
