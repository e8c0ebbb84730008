#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns the true friction coefficient and effects with which a virtual laboratory simulated
/// recordings, for comparison with a diagnosis: the program never reads this JSON. It also contains
/// the plan of the experiment and, for each step, the condition and the data that repeat the
/// simulation.
nlohmann::ordered_json to_json(const LabResult& result);

}  // namespace pendular
