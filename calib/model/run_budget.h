#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/runs/ensemble.h"

namespace pendular {

/// Time limit for simulation runs. The time is counted from the construction of the object.
class RunBudget {
  public:
    /// Makes a budget without a time limit.
    RunBudget() = default;
    /// Makes a budget whose time ends `seconds` [s] after the construction.
    explicit RunBudget(double seconds);

    /// Whether the budget has a time limit.
    bool limited() const { return end_.has_value(); }
    /// Returns the time that is left [s], at least 0. The time is infinite if the budget has no
    /// time limit.
    double seconds_left() const;
    /// Returns how many of the simulation runs `runs`, counted from the first run, are expected to
    /// end within the time left for runs (the time left minus the time `reserved`). Without a time
    /// limit, the function returns the number of all runs.
    /// @param measured finished runs, from whose wall times the wall times of `runs` are estimated
    ///        (`expected_seconds`)
    /// @param threads number of runs carried out at the same time
    /// @param reserved time for other work [s]
    std::size_t affordable(const std::vector<dem::RunParameters>& runs,
                           const std::vector<dem::RunResult>& measured, int threads,
                           double reserved = 0) const;

    /// Returns how many of the simulation runs `runs`, counted from the first run, to carry out
    /// before the most useful runs are chosen again. The returned number of runs is expected to end
    /// within a third of the time left for runs (the time left minus the time `reserved`). The
    /// returned number is at least `threads`, but at most the number that `affordable` returns.
    /// @param measured finished runs, from whose wall times the wall times of `runs` are estimated
    /// @param threads number of runs carried out at the same time
    /// @param reserved time for other work [s]
    std::size_t batch(const std::vector<dem::RunParameters>& runs,
                      const std::vector<dem::RunResult>& measured, int threads,
                      double reserved = 0) const;

    /// Carries out simulation runs (`run_all`) and returns their results in the order of `runs`.
    /// The function stops when only the time `reserved` for other work [s] is left. If some runs
    /// are then unfinished, the function returns only the results that are in the store of
    /// `workers`.
    /// @throws dem::Interrupted if the user stops the work, and all other exceptions that `run_all`
    ///         throws
    std::vector<dem::RunResult> run(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers, double reserved = 0) const;

  private:
    std::optional<std::chrono::steady_clock::time_point> end_;
};

}  // namespace pendular
