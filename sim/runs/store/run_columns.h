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

/// One column of a table of runs, in a store as in a CSV file: how it is written and read back.
struct RunColumn {
    enum class Type { integer, real, text };
    std::string name;
    Type type = Type::real;
    bool determines = false;  ///< a run, rather than saying what came out
    std::function<RunCell(const dem::RunResult&)> get;
    std::function<void(dem::RunResult&, const RunCell&)> set;
};

/// Every column: what determines a run, how it went, and each observable with its standard error
/// (NAME_stderr) and the strain over which it decorrelates (NAME_correlation_strain). Observables
/// of bridges are empty for dry runs, all of them for runs that failed. Profiles and distributions
/// are not kept.
const std::vector<RunColumn>& run_columns();

}  // namespace pendular
