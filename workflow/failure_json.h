#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// Returns the JSON of statistical tests of a fit's residuals: statistic and p value of each test,
/// and one p value of all tests together.
nlohmann::ordered_json to_json(const Checks& checks);

/// Returns the JSON that states where a fitted model fails to describe the readings: the
/// statistical tests of the residuals, and the groups of readings that deviate from the model, each
/// with its p value.
nlohmann::ordered_json to_json(const WhereItFails& where);

}  // namespace pendular
