#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Returns a figure of one simulation: stress ratio and solid fraction, averaged over short blocks
/// of strain, against the shear strain. Horizontal lines mark the averages over the steady state. A
/// vertical line marks the end of the transient.
Figure trace_figure(const StoredRun& run);

/// Returns a figure of one quantity of simulations against another quantity, one point per
/// successful simulation. Error bars show the standard errors of `y` in the table of simulations,
/// if there are any. Colours distinguish dry simulations and three ranges of the reduced pressure
/// of wet simulations. Symbols distinguish simulations without and with physical effects on the
/// grains.
/// @param x column of the table of simulations (`run_columns`) along the x axis
/// @param y column of the table of simulations along the y axis
/// @throws InputError if a column does not exist or contains no numbers, or if no successful
///        simulation has numbers in both columns
Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y);

}  // namespace pendular
