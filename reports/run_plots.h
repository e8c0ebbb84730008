#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Figure of one simulation run: stress ratio and solid fraction, averaged over short blocks of
/// strain, against shear strain. Lines mark the averages of the steady state and the end of the
/// transient.
Figure trace_figure(const StoredRun& run);

/// Figure of one quantity of simulation runs against another, one point per successful run, with
/// standard errors of `y` where the runs have them. Dry runs, and wet runs by range of reduced
/// pressure, differ in colour; runs with effects differ in symbol.
/// @param x column of the table of runs (`run_columns`) along the x axis
/// @param y column of the table of runs along the y axis
/// @throws InputError where a column does not exist or contains no numbers, and where no successful
///         run has numbers in both columns
Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y);

}  // namespace pendular
