#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// JSON of the shifts of the calibrated parameters by each effect and each error of measurement,
/// and by each group of them; sizes and shifts in SI units.
nlohmann::ordered_json to_json(const ImpactTable& table);

}  // namespace pendular
