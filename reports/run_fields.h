#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/dem/run.h"

namespace pendular {

/// Returns the JSON of the profiles and distributions of a simulation. Each profile or distribution
/// has its meaning, unit and coordinate, and the lists `at` (coordinate), `value` and `stderr`
/// (standard error). Each list has one entry per bin. Value and standard error of a bin without
/// data are null. A dry simulation has no profiles or distributions of liquid bridges.
nlohmann::ordered_json fields_json(const dem::RunResult& run);

/// Returns the profiles and distributions of a simulation as CSV tables, one table for each
/// coordinate. The key of the map is the file name, the value is the text of the table. Headers are
/// `NAME [unit]`; the column NAME_sd after each column NAME contains the standard errors.
std::map<std::string, std::string> field_tables(const dem::RunResult& run);

/// Returns two figures of a simulation. `profiles` shows velocity, solid fraction and granular
/// temperature along the velocity gradient. `distributions` shows orientations and forces of
/// contacts and, for wet grains, orientations and gaps of liquid bridges between grains that do not
/// touch.
std::vector<Figure> field_figures(const dem::RunResult& run);

}  // namespace pendular
