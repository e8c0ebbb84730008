#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// JSON of the true friction and effects with which a virtual laboratory simulated its recordings,
/// for comparison with what a diagnosis finds. It also contains the plan of the experiment and, for
/// each step, the condition and all that is needed to repeat the simulation run. The program never
/// reads this JSON.
nlohmann::ordered_json to_json(const LabResult& result);

}  // namespace pendular
