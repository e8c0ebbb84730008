#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/state_prediction.h"

namespace pendular {

/// JSON of a predicted state, as `predict --json` writes it: each observable with its standard
/// error and its derivatives.
nlohmann::ordered_json to_json(const StatePrediction& prediction);

/// JSON of a curve, as `predict --json` writes it.
nlohmann::ordered_json to_json(const PredictionCurve& curve);

/// JSON of a state that was simulated instead of predicted, without derivatives.
nlohmann::ordered_json simulated_state_json(const dem::RunParameters& requested,
                                            const dem::RunResult& run);

}  // namespace pendular
