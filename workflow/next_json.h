#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/next.h"

namespace pendular {

/// JSON of the next measurement to make for a study, as in out/next.json: the rival models, the
/// point to measure and what each model predicts there.
nlohmann::ordered_json to_json(const NextMeasurement& next);

}  // namespace pendular
