#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/next.h"

namespace pendular {

/// Returns the JSON of the next measurement to make for a study, as written to out/next.json. If
/// there are several rival models, the JSON contains their names, the point to measure and the
/// predictions of each model. If there is only one model, the JSON contains the point to measure,
/// and the standard errors of the model's parameters before and after the measurement.
nlohmann::ordered_json to_json(const NextMeasurement& next);

}  // namespace pendular
