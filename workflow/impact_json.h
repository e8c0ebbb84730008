#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/impact.h"

namespace pendular {

/// JSON of an impact table: by how much each missing effect, each error of measurement, and each
/// group of them would shift the calibrated parameters. Sizes of the effects and shifts are in SI
/// units.
nlohmann::ordered_json to_json(const ImpactTable& table);

}  // namespace pendular
