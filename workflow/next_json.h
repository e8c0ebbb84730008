#pragma once

#include <nlohmann/json_fwd.hpp>

#include "workflow/next.h"

namespace pendular {

/// JSON that `next` prints and `out/next.json` holds.
nlohmann::ordered_json to_json(const NextMeasurement& next);

}  // namespace pendular
