#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/state_prediction.h"

namespace pendular {

/// A predicted state as `predict` gives it with --json: each observable with its standard error and
/// its derivatives.
nlohmann::ordered_json to_json(const StatePrediction& prediction);

/// A curve, likewise.
nlohmann::ordered_json to_json(const PredictionCurve& curve);

/// A state that was simulated instead of predicted, likewise, without derivatives.
nlohmann::ordered_json simulated_state_json(const dem::RunParameters& requested,
                                            const dem::RunResult& run);

}  // namespace pendular
