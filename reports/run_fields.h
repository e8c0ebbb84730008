#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/dem/run.h"

namespace pendular {

/// JSON of a run's profiles and distributions: each field with its meaning, unit and coordinate and
/// with the lists `at`, `value` and `stderr`, null for bins without samples. A dry run has no
/// fields of liquid bridges.
nlohmann::ordered_json fields_json(const dem::RunResult& run);

/// Profiles and distributions of a run as CSV: a map from file name to content, with one file per
/// coordinate. Headers are `NAME [unit]`; the column NAME_sd after each value is its standard
/// error.
std::map<std::string, std::string> field_tables(const dem::RunResult& run);

/// Returns the figures `profiles` and `distributions` of a run: velocity, solid fraction and
/// granular temperature across the gradient; orientations, forces and gaps of contacts and bridges.
std::vector<Figure> field_figures(const dem::RunResult& run);

}  // namespace pendular
