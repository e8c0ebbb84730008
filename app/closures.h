#pragma once

#include <optional>

#include "app/console.h"
#include "app/options.h"
#include "sim/closures/closure_values.h"
#include "sim/runs/store/run_store.h"

namespace pendular::app {

/// Prints the values that the closures (analytical formulas) of Badetti et al. (2018) give for a
/// flow of wet grains, one value per line. All values are dimensionless.
/// @param stress_ratio simulated or predicted stress ratio of the flow [1], printed for comparison
///        with the values from the closures
void print_closures(const closures::ClosureValues& values, double stress_ratio, Console& console);

/// Computes and prints the values that the closures (analytical formulas) of Badetti et al. (2018)
/// give for a simulation of wet grains. The closures need the stress ratio of dry grains, which is
/// predicted from earlier simulations. If this prediction is impossible, prints a sentence that
/// says so.
/// @param run result of the simulation
/// @param store user's file of simulations; null: only the simulations supplied with Pendular are
///        used
/// @return the printed values; empty if the simulated grains are dry or if the stress ratio of dry
///         grains cannot be predicted
std::optional<closures::ClosureValues> print_closures_of(const dem::RunResult& run,
                                                         const CommonOptions& common,
                                                         const RunStore* store, Console& console);

}  // namespace pendular::app
