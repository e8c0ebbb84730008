#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

/// One cell of a table of runs: empty, a number or a text.
using RunCell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// One column of a table of runs, in a store or in a CSV file, with the conversions between a run
/// and the column's cell.
struct RunColumn {
    enum class Type { integer, real, text };
    std::string name;
    Type type = Type::real;
    bool determines = false;  ///< whether the column is an input of the run, not a result
    std::function<RunCell(const dem::RunResult&)> get;         ///< returns the cell of a run
    std::function<void(dem::RunResult&, const RunCell&)> set;  ///< sets the value in a run
};

/// All columns of a table of runs: the inputs of a run, its outcome, and each observable with its
/// standard error (NAME_stderr) and the strain over which it decorrelates
/// (NAME_correlation_strain). Observables of bridges are empty for dry runs; all observables are
/// empty for failed runs. There are no columns for profiles and distributions.
const std::vector<RunColumn>& run_columns();

}  // namespace pendular
