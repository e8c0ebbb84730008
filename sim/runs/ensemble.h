#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

class RunStore;

/// Progress of a group of simulations that are carried out together.
struct EnsembleProgress {
    std::size_t runs_done = 0;
    std::size_t runs = 0;  ///< number of simulations in the group
    /// Completed fraction of the expected computing time of all simulations of the group [1].
    /// Simulations whose results are read from a store do not count.
    double fraction = 0;
    /// Estimated time until all runs of the group are complete [s], 0 while unknown.
    double seconds_left = 0;
};
/// Callback that receives the progress of a running group of simulations.
using EnsembleReport = std::function<void(const EnsembleProgress&)>;

/// Settings with which a group of simulations is carried out: number of threads, stop request,
/// progress callback and store (SQLite file of runs).
struct Workers {
    int threads = 1;
    std::stop_token stop;
    /// Callback that receives the progress of the simulations. Only one thread at a time calls the
    /// callback.
    EnsembleReport report;
    /// Store (SQLite file of runs) to which every run is added when it ends, with its time series
    /// and final state; null for no store. With a store, the results that are returned to the
    /// caller lack time series and final state.
    RunStore* store = nullptr;
    /// Whether the result of a run that the store already contains is read from the store.
    /// Otherwise the run is simulated again.
    bool reads_store = true;
};

/// Carries out independent simulations in parallel, one thread per simulation, the longest
/// simulation first. Returns the results in the order of `runs`. The results do not depend on the
/// number of threads. If a simulation fails, its result has only its parameters and
/// `RunResult::failure`, and the other simulations continue. A result that is read from a store has
/// no profiles and no distributions. With a store, a run that is stopped or killed goes on where it
/// was when it is carried out again (`RunCheckpoints`).
/// @throws std::invalid_argument for a run that cannot be simulated
/// @throws dem::Interrupted if a stop is requested
/// @throws InputError, std::runtime_error if the store cannot be read or written
std::vector<dem::RunResult> run_all(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers);

/// Returns the indices of `runs` in the order of decreasing expected computing time. If runs are
/// started in this order, no long run is left to the end.
std::vector<std::size_t> longest_first(const std::vector<dem::RunParameters>& runs);

/// Returns the expected computing time of a run, transient included, in arbitrary units, for
/// comparison with other runs. The computing time is proportional to the number of grains times the
/// number of time steps.
double expected_cost(const dem::RunParameters& run);

/// Returns the expected wall time [s] of `runs` on `threads` threads, one run per thread; empty if
/// no measured run succeeded. The time of a run is its `expected_cost` times the median of (wall
/// time divided by `expected_cost`) over the measured runs of equal kind: dry or wet, with or
/// without physical effects. If no measured run is of equal kind, the median is over all measured
/// runs. The result is at least the time of the longest run.
/// @param measured runs that were already carried out
std::optional<double> expected_seconds(const std::vector<dem::RunParameters>& runs,
                                       const std::vector<dem::RunResult>& measured, int threads);

}  // namespace pendular
