#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

class RunStore;

/// Progress of simulations that are carried out together.
struct EnsembleProgress {
    std::size_t runs_done = 0;
    std::size_t runs = 0;
    /// Completed fraction of the expected computing time [1]; results read from a store do not
    /// count.
    double fraction = 0;
    double seconds_left = 0;  ///< estimate; 0 while unknown
};
/// Callback for the progress of simulations.
using EnsembleReport = std::function<void(const EnsembleProgress&)>;

/// Settings with which simulations are carried out.
struct Workers {
    int threads = 1;
    std::stop_token stop;
    EnsembleReport report;  ///< called by one thread at a time
    /// Store to which every run is added when it ends, with its time series and final state, which
    /// the returned results then lack; null for no store.
    RunStore* store = nullptr;
    bool reads_store = true;  ///< whether stored results are read rather than simulated again
};

/// Carries out independent simulations in parallel, one thread per simulation, the longest first,
/// and returns the results in the order of `runs`. They do not depend on the number of threads. If
/// a simulation fails, its result has only its parameters and `RunResult::failure`, and the others
/// continue. A result that is read from a store has no profiles and no distributions. With a store,
/// a run that is stopped or killed goes on where it was when it is carried out again
/// (`RunCheckpoints`).
/// @throws std::invalid_argument for a run that cannot be simulated
/// @throws dem::Interrupted if a stop is requested
/// @throws InputError, std::runtime_error if the store cannot be read or written
std::vector<dem::RunResult> run_all(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers);

/// Returns the indices of `runs` by decreasing expected computing time, so that no long run is left
/// to the end.
std::vector<std::size_t> longest_first(const std::vector<dem::RunParameters>& runs);

/// Returns the expected computing time of a run, transient included, in arbitrary units. It is
/// proportional to the number of grains times the number of time steps.
double expected_cost(const dem::RunParameters& run);

/// Returns the expected wall time [s] of `runs` on `threads` threads, one run per thread; empty if
/// no measured run succeeded. The time of a run is its `expected_cost` times the median of (wall
/// time over `expected_cost`) over the measured runs of equal kind (dry or wet, with or without
/// effects) or, if there are none, over all. The result is at least the time of the longest run.
/// @param measured runs that were already carried out
std::optional<double> expected_seconds(const std::vector<dem::RunParameters>& runs,
                                       const std::vector<dem::RunResult>& measured, int threads);

}  // namespace pendular
