#pragma once

#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

#include "sim/dem/run.h"

namespace pendular {

class RunStore;

/// Progress of a group of runs.
struct EnsembleProgress {
    std::size_t runs_done = 0;
    std::size_t runs = 0;
    double fraction = 0;      ///< of the work, by grain-steps expected
    double seconds_left = 0;  ///< estimated from the speed so far; 0 while not known
};
using EnsembleReport = std::function<void(const EnsembleProgress&)>;

/// Execution of runs: number of threads, stop flag, progress callback and store.
struct Workers {
    int threads = 1;
    std::stop_token stop;
    EnsembleReport report;      ///< called from one thread at a time
    RunStore* store = nullptr;  ///< receives every run as it ends, with its time series and final
                                ///< state, which are then not among the results
    bool reads_store = true;    ///< runs that are in the store are not carried out again
};

/// Carries out independent runs side by side, one core each, the longest first. The results come in
/// the order asked for and do not depend on the number of threads. A run whose simulation fails has
/// RunResult::failure set and nothing else. One taken from a store has no profiles.
/// @throws std::invalid_argument, dem::Interrupted and what the store throws: the first of them,
/// after the others have stopped
std::vector<dem::RunResult> run_all(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers);

/// Carries out one run. If its simulation fails, only RunResult::failure is set.
dem::RunResult run_one(const dem::RunParameters& run, const dem::RunOptions& options);

/// Order in which to start the runs: the costliest first, so that the last ones to end are short.
std::vector<std::size_t> longest_first(const std::vector<dem::RunParameters>& runs);

/// Expected cost of a run [grains times time steps], transient included; meant for comparison of
/// runs only.
double expected_cost(const dem::RunParameters& run);

/// Time that runs will take on so many threads, a run on each [s]: `expected_cost` at the median
/// speed of measured runs, with or without bridges and effects like them where there are such, in
/// all no less than the longest run. Empty where no run was measured.
std::optional<double> expected_seconds(const std::vector<dem::RunParameters>& runs,
                                       const std::vector<dem::RunResult>& measured, int threads);

}  // namespace pendular
