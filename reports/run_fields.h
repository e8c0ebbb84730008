#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/dem/run.h"

namespace pendular {

/// JSON of the profiles and distributions of a simulation run. Each profile or distribution has its
/// meaning, unit and coordinate, and the lists `at` (coordinate), `value` and `stderr` (standard
/// error) with one entry per bin, null in bins without samples. A dry run has no profiles or
/// distributions of liquid bridges.
nlohmann::ordered_json fields_json(const dem::RunResult& run);

/// Returns the profiles and distributions of a simulation run as CSV tables, by file name; one file
/// for each coordinate. Headers are `NAME [unit]`; the column NAME_sd after each value is its
/// standard error.
std::map<std::string, std::string> field_tables(const dem::RunResult& run);

/// Returns two figures of a simulation run. `profiles`: velocity, solid fraction and granular
/// temperature along the velocity gradient. `distributions`: orientations, forces and gaps of
/// contacts and liquid bridges.
std::vector<Figure> field_figures(const dem::RunResult& run);

}  // namespace pendular
