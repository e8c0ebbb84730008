#pragma once

#include <map>
#include <string>
#include <vector>

#include "reports/figure.h"
#include "sim/dem/run.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Returns stress ratio and solid fraction, averaged over short blocks of strain, against the shear
/// strain. Horizontal lines mark the averages over the steady state, a vertical line the end of the
/// transient.
Figure trace_figure(const StoredRun& run);

/// Returns a figure of one column of the table of simulations (`run_columns`) against another, one
/// point per successful simulation, with the standard errors of `y` if there are any. Colours
/// distinguish dry simulations and three ranges of P*; symbols distinguish simulations without and
/// with effects on grains.
/// @throws InputError if a column does not exist or contains no numbers, or if no successful
///        simulation has numbers in both
Figure runs_figure(const std::vector<StoredRun>& runs, const std::string& x, const std::string& y);

/// Returns the profiles and distributions of a simulation as CSV, one table for each coordinate,
/// keyed by file name. Headers are `NAME [unit]`; a column NAME_sd after each column NAME contains
/// the standard errors.
std::map<std::string, std::string> field_tables(const dem::RunResult& run);

/// Returns `profiles` of velocity, solid fraction and granular temperature along the velocity
/// gradient, and `distributions` of orientations and forces of contacts and, for wet grains, of
/// orientations and gaps of bridges between grains that do not touch.
std::vector<Figure> field_figures(const dem::RunResult& run);

}  // namespace pendular
