#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "sim/catalogue/effect.h"
#include "sim/closures/closure_values.h"
#include "sim/dem/run.h"

namespace pendular {

/// Returns {"value": number, "stderr": standard error}, both in the unit of the number.
nlohmann::ordered_json uncertain(double value, double error);

/// Returns the JSON of the parameter values of effects, in the units of the parameters, with keys
/// "EFFECT.PARAMETER", such as "torque-offset.torque".
nlohmann::ordered_json effects_json(const std::vector<ActiveEffect>& effects);

/// Returns the JSON of a run: each observable as {"value", "stderr"}, and all parameters that are
/// needed to repeat the run. Observables of liquid bridges are zero in a run of dry grains.
/// Parameters of effects on grains are under the key `effects_in_run_units`, in units in which
/// grain diameter, grain mass and normal stress are 1.
nlohmann::ordered_json to_json(const dem::RunResult& run);

/// Returns the JSON of the closures of Badetti et al. (2018) for a wet state; all are
/// dimensionless.
nlohmann::ordered_json closures_json(const closures::ClosureValues& values);

/// Reads the result of a run from the JSON that `to_json` writes for it. Observables that are
/// missing from the JSON of an earlier version are zero.
/// @throws nlohmann::json::exception if a key is missing or its value has a wrong type
dem::RunResult run_from_json(const nlohmann::ordered_json& json);

}  // namespace pendular
