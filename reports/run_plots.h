#pragma once

#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Returns a figure of one simulation: stress ratio and solid fraction, averaged over short blocks
/// of strain, against the shear strain. Lines mark the averages over the steady state and the end
/// of the transient.
Figure trace_figure(const StoredRun& run);

/// Returns a figure of one quantity of simulations against another quantity, one point per
/// successful simulation, with standard errors of `y` where the simulations have standard errors.
/// Colours distinguish dry simulations and three ranges of the reduced pressure of wet simulations.
/// Symbols distinguish simulations without and with physical effects on the grains.
/// @param x column of the table of simulations (`run_columns`) along the x axis
/// @param y column of the table of simulations along the y axis
/// @throws InputError where a column does not exist or contains no numbers, and where no successful
///         simulation has numbers in both columns
Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y);

}  // namespace pendular
