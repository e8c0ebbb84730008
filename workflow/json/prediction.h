#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/reproduction.h"
#include "workflow/state_prediction.h"

namespace pendular {

/// Returns the JSON of a prediction, as `pendular predict --json` writes it: each observable with
/// its standard error and its derivatives with respect to friction coefficient, logarithm of
/// inertial number, inverse reduced pressure and bridge volume.
/// @param runs training runs of the emulator
nlohmann::ordered_json to_json(const StatePrediction& prediction,
                               const std::vector<dem::RunResult>& runs);

/// Returns the JSON of a curve (`--along`): an array of states with their observables.
nlohmann::ordered_json to_json(const PredictionCurve& curve,
                               const std::vector<dem::RunResult>& runs);

/// Returns the JSON of a state that was simulated instead of predicted: each observable with its
/// standard error, without derivatives.
/// @param requested parameters of the requested run, which give the state
nlohmann::ordered_json simulated_state_json(const dem::RunParameters& requested,
                                            const dem::RunResult& run);

/// Returns the JSON of a reproduction, as `pendular reproduce --json` writes it.
nlohmann::ordered_json to_json(const Reproduction& reproduction);

}  // namespace pendular
