#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "sim/runs/ensemble.h"

namespace pendular {

/// Time limit for simulation runs, counted from the construction of the object. Below, `reserved`
/// is time for other work [s], subtracted from the time left; `threads` is the number of runs
/// carried out at the same time; wall times follow from those of the finished runs `measured`
/// (`expected_seconds`).
class RunBudget {
  public:
    /// Makes a budget without a time limit.
    RunBudget() = default;
    /// Makes a budget whose time ends `seconds` [s] after the construction; without a time limit if
    /// this is infinite or at least 1e9 s.
    /// @throws InputError if `seconds` is negative or no number
    explicit RunBudget(double seconds);

    bool limited() const { return end_.has_value(); }
    /// Returns the time that is left [s], at least 0; infinite without a time limit.
    double seconds_left() const;
    /// Returns how many of `runs`, from the first, are expected to end in time; all without a
    /// limit.
    std::size_t affordable(const std::vector<dem::RunParameters>& runs,
                           const std::vector<dem::RunResult>& measured, int threads,
                           double reserved = 0) const;

    /// Returns how many of `runs`, from the first, to carry out before the most useful runs are
    /// chosen again: as many as are expected to end within a third of the time left, but at least
    /// `threads`, and at most what `affordable` returns.
    std::size_t batch(const std::vector<dem::RunParameters>& runs,
                      const std::vector<dem::RunResult>& measured, int threads,
                      double reserved = 0) const;

    /// Carries out `runs` (`run_all`) and returns their results in this order. Once only `reserved`
    /// [s] is left, stops them, and returns those that the store of `workers` has.
    /// @throws dem::Interrupted if the user stops the work, and all other exceptions of `run_all`
    std::vector<dem::RunResult> run(const std::vector<dem::RunParameters>& runs,
                                    const Workers& workers, double reserved = 0) const;

  private:
    std::optional<std::chrono::steady_clock::time_point> end_;
};

}  // namespace pendular
