#pragma once

#include <optional>

#include "app/console.h"
#include "app/options.h"
#include "sim/closures/closure_values.h"
#include "sim/runs/store/run_store.h"

namespace pendular::app {

/// Prints the closures (analytical formulas) of Badetti et al. (2018) for a flow of wet grains, one
/// dimensionless value per line.
/// @param stress_ratio simulated or predicted stress ratio [1], printed for comparison
void print_closures(const closures::ClosureValues& values, double stress_ratio, Console& console);

/// Computes, prints and returns the closures for a simulation. They need the stress ratio of dry
/// grains, which is predicted from earlier simulations; if that is impossible, a sentence says so.
/// Empty then, and for dry grains.
/// @param store null: only the atlas is used
std::optional<closures::ClosureValues> print_closures_of(const dem::RunResult& run,
                                                         const CommonOptions& common,
                                                         const RunStore* store, Console& console);

}  // namespace pendular::app
