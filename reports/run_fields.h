#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/dem/run.h"

namespace pendular {

/// Returns the profiles and distributions of a simulation as JSON, each with meaning, unit,
/// coordinate and the lists `at`, `value` and `stderr`, one entry per bin (null: no data). Dry
/// simulations have none of liquid bridges.
nlohmann::ordered_json fields_json(const dem::RunResult& run);

/// Returns the same as CSV, one table for each coordinate, keyed by file name. Headers are `NAME
/// [unit]`; a column NAME_sd after each column NAME contains the standard errors.
std::map<std::string, std::string> field_tables(const dem::RunResult& run);

/// Returns `profiles` of velocity, solid fraction and granular temperature along the velocity
/// gradient, and `distributions` of orientations and forces of contacts and, for wet grains, of
/// orientations and gaps of bridges between grains that do not touch.
std::vector<Figure> field_figures(const dem::RunResult& run);

}  // namespace pendular
