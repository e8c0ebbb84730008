#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/next.h"

namespace pendular {

/// Returns the JSON of the next measurement of a study, as written to out/next.json. The JSON
/// contains the point to measure. If there are several rival models, the JSON also contains the
/// predictions of each model. If there is only one model, the JSON also contains the standard
/// errors of its parameters before and after the measurement.
nlohmann::ordered_json to_json(const NextMeasurement& next);

}  // namespace pendular
