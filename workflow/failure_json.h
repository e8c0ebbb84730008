#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// Returns the JSON of tests of a fit's residuals: statistic and p value of each test, and one p
/// value of all tests together.
nlohmann::ordered_json to_json(const Checks& checks);

/// Returns the JSON of the tests and of the groups of readings that deviate from the fitted model,
/// each group with its p value.
nlohmann::ordered_json to_json(const WhereItFails& where);

}  // namespace pendular
