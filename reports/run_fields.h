#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/dem/run.h"

namespace pendular {

/// JSON of a simulation run's profiles and distributions: for each field its meaning, unit and
/// coordinate and, by bin, the lists `at` (coordinate), `value` and `stderr` (standard error), null
/// in bins without samples. A dry run has no fields of liquid bridges.
nlohmann::ordered_json fields_json(const dem::RunResult& run);

/// Profiles and distributions of a simulation run as CSV: a map from file name to content, with one
/// file per coordinate. Headers are `NAME [unit]`; the column NAME_sd after each value is its
/// standard error.
std::map<std::string, std::string> field_tables(const dem::RunResult& run);

/// Returns the figures `profiles` and `distributions` of a simulation run: velocity, solid fraction
/// and granular temperature along the velocity gradient; orientations, forces and gaps of contacts
/// and liquid bridges.
std::vector<Figure> field_figures(const dem::RunResult& run);

}  // namespace pendular
