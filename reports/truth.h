#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// JSON of the hidden truth behind the recordings that a virtual laboratory wrote, for users and
/// scripts: friction and effects, plan of the experiment, and the condition and simulation run of
/// each step, with all that is needed to repeat the run. The program never reads this JSON.
nlohmann::ordered_json to_json(const LabResult& result);

}  // namespace pendular
