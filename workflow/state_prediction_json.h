#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/state_prediction.h"

namespace pendular {

/// Returns the JSON of the predictions at one state of steady shear, as `pendular predict --json`
/// writes it: each observable (such as the stress ratio) with its standard error and its
/// derivatives with respect to friction coefficient, logarithm of inertial number, inverse reduced
/// pressure and bridge volume.
nlohmann::ordered_json to_json(const StatePrediction& prediction);

/// Returns the JSON of the predictions along a curve of states, as `pendular predict --along
/// --json` writes it: an array of states of steady shear that differ in one quantity. Each state
/// has its observables (such as the stress ratio), their standard errors and their derivatives.
nlohmann::ordered_json to_json(const PredictionCurve& curve);

/// Returns the JSON of a state of steady shear that was simulated instead of predicted, as
/// `pendular predict --json` writes it: each observable (such as the stress ratio) with its
/// standard error, without derivatives.
/// @param requested parameters of the requested run, which give the state
nlohmann::ordered_json simulated_state_json(const dem::RunParameters& requested,
                                            const dem::RunResult& run);

}  // namespace pendular
