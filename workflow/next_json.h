#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/next.h"

namespace pendular {

/// JSON of the next measurement to make for a study, which `pendular next` prints and writes to
/// out/next.json.
nlohmann::ordered_json to_json(const NextMeasurement& next);

}  // namespace pendular
