#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// Returns the JSON of an impact table. Sizes of effects and errors, and shifts of parameters, are
/// in SI units.
nlohmann::ordered_json to_json(const ImpactTable& table);

}  // namespace pendular
