#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"

namespace pendular {

/// Number with its error as {"value", "stderr"}, both in the same unit.
nlohmann::ordered_json uncertain(double value, double error);

/// Values of effects as `calibrate` names fitted parameters, "EFFECT.PARAMETER", in SI units.
nlohmann::ordered_json effects_json(const std::vector<ActiveEffect>& effects);

/// JSON of a run with its observables, each {"value", "stderr"}, and all that is needed to repeat
/// it. Observables of liquid bridges are zero in a dry run. Effects on grains, where there are any,
/// stand under `effects_in_run_units`.
nlohmann::ordered_json to_json(const dem::RunResult& run);

/// Reads a run back from JSON.
dem::RunResult run_from_json(const nlohmann::ordered_json& json);

}  // namespace pendular
