#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns the JSON of the true friction coefficient and the true effects with which a virtual
/// laboratory simulated rheometer recordings. The user compares the result of a diagnosis with
/// these true values. The program never reads this JSON. The JSON also contains the plan of the
/// experiment and, for each step, the condition and the data for a repetition of the simulation.
nlohmann::ordered_json to_json(const LabResult& result);

}  // namespace pendular
