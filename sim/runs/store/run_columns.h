#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

/// Content of one cell in a table of simulation runs: empty, a number or a text.
using RunCell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// Column of a table of simulation runs, in a store (SQLite file of runs) or a CSV file. Its
/// functions convert between a run and the cell of this column.
struct RunColumn {
    enum class Type { integer, real, text };
    std::string name;
    Type type = Type::real;
    /// True if the column contains an input of the run rather than a result.
    bool determines = false;
    /// Function that returns the cell of this column for a run.
    std::function<RunCell(const dem::RunResult&)> get;
    /// Function that sets the value of this column in a run to that of a cell.
    std::function<void(dem::RunResult&, const RunCell&)> set;
};

/// All columns of a table of simulation runs: the inputs of a run, its outcome, and each observable
/// with its standard error (NAME_stderr) and the shear strain [1] over which its fluctuations
/// decorrelate (NAME_correlation_strain). Observables of bridges are empty for dry runs; all
/// observables are empty for failed runs. Profiles and distributions have no columns.
const std::vector<RunColumn>& run_columns();

}  // namespace pendular
