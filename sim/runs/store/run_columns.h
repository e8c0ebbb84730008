#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

/// Content of one cell in a table of simulation runs.
using RunCell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// Column of a table of simulation runs, which is a store or a CSV file, with the functions that
/// convert between a run and its cell in this column.
struct RunColumn {
    enum class Type { integer, real, text };
    std::string name;
    Type type = Type::real;
    bool determines = false;  ///< whether it is an input of the run, not a result
    std::function<RunCell(const dem::RunResult&)> get;
    std::function<void(dem::RunResult&, const RunCell&)> set;
};

/// Returns all columns: inputs of a run, outcome (such as number of time steps, wall time and
/// failure) and observables. Each observable also has columns for its standard error (NAME_stderr)
/// and for the shear strain [1] over which it decorrelates (NAME_correlation_strain). Observables
/// of bridges are empty for dry runs, all observables for failed runs. Profiles and distributions
/// have no columns.
const std::vector<RunColumn>& run_columns();

}  // namespace pendular
