#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// All checks of a fit, and the probability that they look so bad together.
nlohmann::ordered_json to_json(const Checks& checks);

/// The checks of a fit and the readings that stand out.
nlohmann::ordered_json to_json(const WhereItFails& where);

}  // namespace pendular
