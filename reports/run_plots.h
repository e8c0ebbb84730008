#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Figure of one run over its strain: stress ratio and solid fraction averaged over short blocks of
/// strain, with the averages of the steady state and the end of the transient.
Figure trace_figure(const StoredRun& run);

/// Figure of one column of `run_columns()` against another, one point per run that did not fail,
/// with standard errors where there are any. Dry runs, wet runs by range of reduced pressure, and
/// runs with effects on grains have different colours and symbols.
/// @throws InputError for a column that does not exist or holds no numbers, and where no run has
///         both columns
Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y);

}  // namespace pendular
