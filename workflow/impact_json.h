#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// Returns the JSON of an impact table: the shifts of the calibrated parameters that each effect
/// which the model may lack, each error of measurement, and each group of effects or errors would
/// cause. Sizes and shifts are in SI units.
nlohmann::ordered_json to_json(const ImpactTable& table);

}  // namespace pendular
