#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/dem/run.h"

namespace pendular {

/// A run's "profiles" and "distributions": each field with its meaning, its unit, the coordinate's,
/// and lists `at`, `value` and `stderr`, null where there was nothing to average. Fields of bridges
/// are left out of dry runs.
nlohmann::ordered_json fields_json(const dem::RunResult& run);

/// Fields of a run as CSV: file name to content, a file per coordinate, headers `name [unit]`, each
/// value followed by its standard error NAME_sd.
std::map<std::string, std::string> field_tables(const dem::RunResult& run);

/// Fields of a run as the figures `profiles` and `distributions`.
std::vector<Figure> field_figures(const dem::RunResult& run);

}  // namespace pendular
