#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "sim/catalogue/effect.h"
#include "sim/closures/closure_values.h"
#include "sim/dem/run.h"

namespace pendular {

/// JSON of a number with its standard error, {"value", "stderr"}, both in the unit of the number.
nlohmann::ordered_json uncertain(double value, double error);

/// JSON of the parameter values of a model's effects, with the keys "EFFECT.PARAMETER" that fitted
/// parameters have in fit.json.
nlohmann::ordered_json effects_json(const std::vector<ActiveEffect>& effects);

/// JSON of a run: its observables, each {"value", "stderr"}, and all parameters that are needed to
/// repeat it. Observables of liquid bridges are zero in a dry run. Effects on grains, if there are
/// any, are under the key `effects_in_run_units`.
nlohmann::ordered_json to_json(const dem::RunResult& run);

/// JSON of the values that closures (analytical formulas) give for a wet state [1].
nlohmann::ordered_json closures_json(const closures::ClosureValues& values);

/// Reads the result of a run from JSON that `to_json` made of it. Observables that earlier versions
/// did not write are zero.
dem::RunResult run_from_json(const nlohmann::ordered_json& json);

}  // namespace pendular
