#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

/// Content of one cell in a table of simulation runs: empty, an integer, a real number or a text.
using RunCell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// Column of a table of simulation runs. The table is a store (SQLite file of runs) or a CSV file.
/// The functions of the column convert between a run and the cell of the run in this column.
struct RunColumn {
    enum class Type { integer, real, text };
    std::string name;
    Type type = Type::real;
    /// Whether the column contains an input of the run rather than a result.
    bool determines = false;
    /// Function that returns the content of the cell for a run in this column.
    std::function<RunCell(const dem::RunResult&)> get;
    /// Function that sets, in a run, the quantity of this column to the value of a cell.
    std::function<void(dem::RunResult&, const RunCell&)> set;
};

/// Returns all columns of a table of simulation runs: inputs of a run, outcome (such as number of
/// time steps, wall time and failure) and observables. Each observable has a column for its
/// standard error (NAME_stderr) and a column for the shear strain [1] over which the observable
/// decorrelates (NAME_correlation_strain). Observables of bridges are empty for dry runs. All
/// observables are empty for failed runs. Profiles and distributions have no columns.
const std::vector<RunColumn>& run_columns();

}  // namespace pendular
