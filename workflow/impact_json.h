#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// Returns the JSON of an impact table. The table states by how much each effect that the model may
/// lack, each error of measurement, and each group of effects or errors would shift the calibrated
/// parameters. Sizes of effects and errors, and shifts of parameters, are in SI units.
nlohmann::ordered_json to_json(const ImpactTable& table);

}  // namespace pendular
