#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Course of one run over its strain: stress ratio and solid fraction block by block, with their
/// averages and the end of the transient.
Figure trace_figure(const StoredRun& run);

/// One column of `run_columns()` against another, with standard errors where there are any: dry
/// runs, and wet ones by decade of reduced pressure; those with effects on grains apart.
/// @throws InputError for a column that is not there or holds no numbers
Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y);

}  // namespace pendular
