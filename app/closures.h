#pragma once

#include <optional>

#include "app/console.h"
#include "app/options.h"
#include "sim/closures/closure_values.h"
#include "sim/runs/store/run_store.h"

namespace pendular::app {

/// Prints what the formulas of Badetti et al. (2018) give for a wet state.
/// @param stress_ratio stress ratio of the state itself [1], printed for comparison
void print_closures(const closures::ClosureValues& values, double stress_ratio, Console& console);

/// Prints what the formulas give for the state of a wet run, from its averages and the stress ratio
/// of dry grains, predicted from the runs in atlas and store.
/// @param store user's file of runs; may be null
/// @return the printed values; empty for a dry run and where those runs do not give the stress
///         ratio of dry grains, which is printed
std::optional<closures::ClosureValues> print_closures_of(const dem::RunResult& run,
                                                         const CommonOptions& common,
                                                         const RunStore* store, Console& console);

}  // namespace pendular::app
