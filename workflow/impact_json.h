#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// JSON of what each effect and each error of measurement does to the calibrated parameters, single
/// and by group; sizes and shifts in SI units.
nlohmann::ordered_json to_json(const ImpactTable& table);

}  // namespace pendular
