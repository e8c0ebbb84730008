#pragma once

#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"

namespace pendular {

/// JSON of all checks (tests of the residuals) of a fit, each with its statistic and p value, and
/// the p value of all checks together.
nlohmann::ordered_json to_json(const Checks& checks);

/// JSON of the checks (tests of the residuals) of a fit, and of the groups of readings that deviate
/// from the model, each with its p value.
nlohmann::ordered_json to_json(const WhereItFails& where);

}  // namespace pendular
