#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Figure of one simulation run against its shear strain: stress ratio and solid fraction averaged
/// over short blocks of strain, with lines at the averages of the steady state and at the end of
/// the transient.
Figure trace_figure(const StoredRun& run);

/// Figure of column `y` of `run_columns()` (the values listed for each simulation run) against
/// column `x`, one point per successful run, with standard errors of `y` where a column has them.
/// Dry runs and wet runs by range of reduced pressure differ in colour, runs with effects in
/// symbol.
/// @throws InputError for a column that does not exist or holds no numbers, and where no successful
///         run has numbers in both columns
Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y);

}  // namespace pendular
