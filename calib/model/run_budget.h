#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/runs/ensemble.h"

namespace pendular {

/// Time that simulation runs may take, counted from the construction of the budget.
class RunBudget {
  public:
    /// Budget without a limit.
    RunBudget() = default;
    /// Budget of `seconds` from now [s].
    explicit RunBudget(double seconds);

    bool limited() const { return end_.has_value(); }
    /// Time left [s]; infinite without a limit, never below 0.
    double seconds_left() const;
    /// Number n such that the first n of `runs` are expected to end within the time left minus the
    /// time `reserved` for other work [s]; without a limit, the number of all runs.
    /// @param measured finished runs, from whose wall times the wall times of `runs` are estimated
    ///        (`expected_seconds`)
    std::size_t affordable(const std::vector<dem::RunParameters>& runs,
                           const std::vector<dem::RunResult>& measured, int threads,
                           double reserved = 0) const;

    /// Number n such that the first n of `runs` should be carried out before the best runs are
    /// chosen again: the number of runs that are `affordable` within a third of the time left, or
    /// one run per thread if that is more. At most the number of affordable runs.
    std::size_t batch(const std::vector<dem::RunParameters>& runs,
                      const std::vector<dem::RunResult>& measured, int threads,
                      double reserved = 0) const;

    /// Carries out runs as `run_all` does, but ends at the end of the budget minus the time
    /// `reserved` [s]. In that case it returns the runs that are finished and in the store of
    /// `workers`, in the order of `runs`.
    /// @throws whatever `run_all` throws; dem::Interrupted only where the user stops the work
    std::vector<dem::RunResult> run(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers, double reserved = 0) const;

  private:
    std::optional<std::chrono::steady_clock::time_point> end_;
};

}  // namespace pendular
