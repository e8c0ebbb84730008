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
    /// Number of the first of `runs` that are expected to end within the time left, less the time
    /// `reserved` for other work [s]; all without a limit.
    /// @param measured runs with their wall times, from which those of `runs` are expected
    ///        (`expected_seconds`)
    std::size_t affordable(const std::vector<dem::RunParameters>& runs,
                           const std::vector<dem::RunResult>& measured, int threads,
                           double reserved = 0) const;

    /// Number of the first of `runs` to make before it is decided anew which runs are best: those
    /// that are `affordable` within a third of the time left or, if more, one for each thread.
    std::size_t batch(const std::vector<dem::RunParameters>& runs,
                      const std::vector<dem::RunResult>& measured, int threads,
                      double reserved = 0) const;

    /// Carries out runs as `run_all` does, but ends at the end of the budget less the time
    /// `reserved` [s]: then it returns those runs that had ended and are in the store of `workers`,
    /// in the order of `runs`.
    /// @throws whatever `run_all` throws; dem::Interrupted only where the user stops the work
    std::vector<dem::RunResult> run(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers, double reserved = 0) const;

  private:
    std::optional<std::chrono::steady_clock::time_point> end_;
};

}  // namespace pendular
