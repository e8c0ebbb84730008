#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

/// One cell (row and column) of a table of simulation runs: empty, a number or a text.
using RunCell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// One column of a table of simulation runs, in a store (SQLite file of runs) or a CSV file, with
/// the conversions between a run and its cell in this column.
struct RunColumn {
    enum class Type { integer, real, text };
    std::string name;
    Type type = Type::real;
    bool determines = false;  ///< whether the column is an input of the run, not a result
    std::function<RunCell(const dem::RunResult&)> get;         ///< cell of a run
    std::function<void(dem::RunResult&, const RunCell&)> set;  ///< sets a run's value
};

/// All columns of a table of runs: the inputs of a run, its outcome, and each observable with its
/// standard error (NAME_stderr) and the strain over which it decorrelates
/// (NAME_correlation_strain). Observables of bridges are empty for dry runs; all observables are
/// empty for failed runs. There are no columns for profiles and distributions.
const std::vector<RunColumn>& run_columns();

}  // namespace pendular
