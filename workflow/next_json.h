#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/next.h"

namespace pendular {

/// Returns the JSON of the next measurement, as written to out/next.json: the point with the
/// predictions of each rival or, if there is only one model, with the standard errors of its
/// parameters before and after the measurement.
nlohmann::ordered_json to_json(const NextMeasurement& next);

}  // namespace pendular
