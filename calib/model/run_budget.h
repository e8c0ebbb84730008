#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/runs/ensemble.h"

namespace pendular {

/// Time limit for simulation runs. The time begins when the budget is constructed.
class RunBudget {
  public:
    /// Makes a time budget without a limit.
    RunBudget() = default;
    /// Makes a time budget that ends `seconds` [s] after this call.
    explicit RunBudget(double seconds);

    /// Whether the budget has a time limit.
    bool limited() const { return end_.has_value(); }
    /// Time that is left of the budget [s]: at least 0; infinite for a budget without a limit.
    double seconds_left() const;
    /// Returns how many of `runs`, taken from the first, are expected to end within the time left
    /// minus the time `reserved` for other work [s]; all of them without a limit.
    /// @param measured finished runs, from whose wall times those of `runs` are estimated
    ///        (`expected_seconds`)
    /// @param threads number of runs carried out at the same time
    std::size_t affordable(const std::vector<dem::RunParameters>& runs,
                           const std::vector<dem::RunResult>& measured, int threads,
                           double reserved = 0) const;

    /// Returns how many of `runs`, taken from the first, to carry out before the best runs are
    /// chosen again: as many as are expected to end within a third of the time left, or one for
    /// each thread if that is more, but not more than `affordable` returns.
    /// @param measured finished runs, from whose wall times those of `runs` are estimated
    /// @param threads number of runs carried out at the same time
    /// @param reserved time for other work [s]
    std::size_t batch(const std::vector<dem::RunParameters>& runs,
                      const std::vector<dem::RunResult>& measured, int threads,
                      double reserved = 0) const;

    /// Carries out runs (`run_all`) until they are finished or the budget, minus the time
    /// `reserved` for other work [s], ends. Returns the results in the order of `runs`; if the
    /// budget ends first, only those of finished runs that are in the store of `workers`.
    /// @throws dem::Interrupted if the user stops the work, and whatever else `run_all` throws
    std::vector<dem::RunResult> run(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers, double reserved = 0) const;

  private:
    std::optional<std::chrono::steady_clock::time_point> end_;
};

}  // namespace pendular
