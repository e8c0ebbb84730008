#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

class RunStore;

/// Progress of a group of runs that are carried out together.
struct EnsembleProgress {
    std::size_t runs_done = 0;
    std::size_t runs = 0;     ///< number of runs in the group
    double fraction = 0;      ///< completed fraction of the total `expected_cost` [1]
    double seconds_left = 0;  ///< estimated time to the end [s]; 0 while unknown
};
/// Callback that receives the progress of a group of runs as the runs advance.
using EnsembleReport = std::function<void(const EnsembleProgress&)>;

/// How runs are carried out: number of threads, stop flag, progress callback and store.
struct Workers {
    int threads = 1;
    std::stop_token stop;
    EnsembleReport report;  ///< called from one thread at a time
    /// Store (SQLite file of runs) that receives every run as it ends, with its time series and
    /// final state, which are then omitted from the returned results; null: no store.
    RunStore* store = nullptr;
    /// Whether a run that is in the store is read from it instead of being simulated again.
    bool reads_store = true;
};

/// Carries out independent runs in parallel, one thread each, the longest first. Returns the
/// results in the order of `runs`; they do not depend on the number of threads. The result of a run
/// whose simulation fails holds only its parameters and RunResult::failure. A run read from a store
/// has no profiles.
/// @throws std::invalid_argument for a run that cannot be simulated, dem::Interrupted on a stop
///         request, and whatever the functions of the store throw; the first error ends all runs
std::vector<dem::RunResult> run_all(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers);

/// Carries out one simulation run in the calling thread and returns its time averages. If the
/// simulation fails (dem::SimulationError), the result holds only the parameters of the run and
/// RunResult::failure; whatever else `simulate` throws is not caught.
dem::RunResult run_one(const dem::RunParameters& run, const dem::RunOptions& options);

/// Returns the indices of `runs` by decreasing expected cost: the order in which to start them, so
/// that no long run is left to the end.
std::vector<std::size_t> longest_first(const std::vector<dem::RunParameters>& runs);

/// Returns the expected cost of a run, transient included, in arbitrary units proportional to
/// grains times time steps; for comparison between runs.
double expected_cost(const dem::RunParameters& run);

/// Returns the wall time [s] that `runs` are expected to take on `threads` threads, one run per
/// thread, from their `expected_cost` and the median wall time per cost of `measured`, runs already
/// carried out. For each run, the median is taken over the measured runs of the same kind (wet or
/// dry, with or without effects) or, if there are none, over all measured runs. The time is at
/// least that of the longest run; empty if no measured run succeeded.
std::optional<double> expected_seconds(const std::vector<dem::RunParameters>& runs,
                                       const std::vector<dem::RunResult>& measured, int threads);

}  // namespace pendular
