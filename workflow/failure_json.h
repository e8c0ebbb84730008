#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// JSON of the checks of a fit, which are tests of its residuals: statistic and p value of each
/// check, and one p value of all checks together.
nlohmann::ordered_json to_json(const Checks& checks);

/// JSON that states where a fitted model fails on the readings: the tests of its residuals, and the
/// groups of readings that deviate from the model, each with its p value.
nlohmann::ordered_json to_json(const WhereItFails& where);

}  // namespace pendular
