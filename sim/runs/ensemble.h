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
    /// Completed fraction of the expected computing time of the runs that are carried out [1]. Runs
    /// that are read from the store do not count.
    double fraction = 0;
    /// Estimated time until all runs of the group are complete [s], 0 while unknown.
    double seconds_left = 0;
};
/// Callback that receives the progress of a running group of simulations.
using EnsembleReport = std::function<void(const EnsembleProgress&)>;

/// Settings with which simulations are carried out: number of threads, stop request, progress
/// callback and store.
struct Workers {
    int threads = 1;
    std::stop_token stop;
    /// Callback that receives the progress of the simulations. Only one thread at a time calls the
    /// callback.
    EnsembleReport report;
    /// Store (SQLite file of runs) to which every run is added when the run ends, with its time
    /// series and final state. The results that are returned to the caller then lack time series
    /// and final state. If the pointer is null, no store is used.
    RunStore* store = nullptr;
    /// Whether a run that the store already contains is read from the store instead of being
    /// simulated again.
    bool reads_store = true;
};

/// Carries out independent simulations in parallel, one thread per simulation, the longest
/// simulation first. Returns the results in the order of `runs`. The results do not depend on the
/// number of threads. If a simulation fails, its result has only its parameters and
/// `RunResult::failure`, and the other simulations continue. A result that is read from a store has
/// no profiles and no distributions.
/// @throws std::invalid_argument for a run that cannot be simulated
/// @throws dem::Interrupted if a stop is requested
/// @throws InputError, std::runtime_error if the store cannot be read or written
std::vector<dem::RunResult> run_all(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers);

/// Carries out one simulation in the calling thread and returns the averages of its observables. If
/// the simulation fails (dem::SimulationError), the result has only the parameters of the run and
/// `RunResult::failure`.
/// @throws std::invalid_argument for a run that cannot be simulated
/// @throws dem::Interrupted if a stop is requested
/// @throws InputError if the checkpoint belongs to a run other than `run` or to another version of
///         the program, or is corrupt
dem::RunResult run_one(const dem::RunParameters& run, const dem::RunOptions& options);

/// Returns the indices of `runs` in the order of decreasing expected computing time. If runs are
/// started in this order, no long run is left to the end.
std::vector<std::size_t> longest_first(const std::vector<dem::RunParameters>& runs);

/// Returns the expected computing time of a run, transient included, in arbitrary units, for
/// comparison with other runs. The computing time is proportional to the number of grains times the
/// number of time steps.
double expected_cost(const dem::RunParameters& run);

/// Returns the expected wall time [s] of `runs` on `threads` threads, one run per thread; empty if
/// no measured run succeeded. The time of a run is its `expected_cost` times the median, over
/// measured runs, of wall time divided by expected cost. The median is over measured runs of the
/// same kind: dry or wet, with or without effects. If no measured run is of this kind, the median
/// is over all measured runs. The result is at least the time of the longest run.
/// @param measured runs that were already carried out
std::optional<double> expected_seconds(const std::vector<dem::RunParameters>& runs,
                                       const std::vector<dem::RunResult>& measured, int threads);

}  // namespace pendular
