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
    /// Completed fraction of the total expected computing time of the group of runs [1].
    double fraction = 0;
    /// Estimated time until all runs of the group are complete [s]; 0 while unknown.
    double seconds_left = 0;
};
/// Callback that receives the progress of a group of simulations while they run.
using EnsembleReport = std::function<void(const EnsembleProgress&)>;

/// Settings with which simulations are carried out: number of threads, stop request, progress
/// callback and store.
struct Workers {
    int threads = 1;
    std::stop_token stop;
    /// Callback that receives the progress; called from one thread at a time.
    EnsembleReport report;
    /// Store (SQLite file of runs) to which every run is added when it ends, with its time series
    /// and final state. The results that are returned to the caller then lack time series and final
    /// state. Null: no store.
    RunStore* store = nullptr;
    /// Whether a run that the store already contains is read from it instead of being simulated
    /// again.
    bool reads_store = true;
};

/// Carries out independent simulations in parallel, one thread each, the longest first. Returns the
/// results in the order of `runs`; they do not depend on the number of threads. If a simulation
/// fails, its result has only its parameters and `RunResult::failure`. A run that is read from a
/// store has no profiles. An error other than the failure of a simulation ends all runs.
/// @throws std::invalid_argument for a run that cannot be simulated
/// @throws dem::Interrupted if a stop is requested
/// @throws InputError, std::runtime_error if the store cannot be read or written
std::vector<dem::RunResult> run_all(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers);

/// Carries out one simulation in the calling thread and returns its time averages. If the
/// simulation fails (dem::SimulationError), the result has only the parameters of the run and
/// `RunResult::failure`.
/// @throws std::invalid_argument for a run that cannot be simulated
/// @throws dem::Interrupted if a stop is requested
/// @throws InputError if the checkpoint belongs to another run or version, or is corrupt
dem::RunResult run_one(const dem::RunParameters& run, const dem::RunOptions& options);

/// Returns the indices of `runs` in the order of decreasing expected computing time. Runs that are
/// started in this order leave no long run to the end.
std::vector<std::size_t> longest_first(const std::vector<dem::RunParameters>& runs);

/// Returns the expected computing time of a run, transient included, in arbitrary units
/// (proportional to number of grains times number of time steps), for comparison between runs.
double expected_cost(const dem::RunParameters& run);

/// Returns the expected wall time [s] of `runs` on `threads` threads, one run per thread; empty if
/// no measured run succeeded. The time of a run is its `expected_cost` times the median time per
/// cost of similar measured runs (both wet or both dry, both with or both without effects). If no
/// measured run is similar, the median of all measured runs is used. The result is at least the
/// time of the longest run.
/// @param measured runs that were already carried out
std::optional<double> expected_seconds(const std::vector<dem::RunParameters>& runs,
                                       const std::vector<dem::RunResult>& measured, int threads);

}  // namespace pendular
