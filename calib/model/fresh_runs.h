#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"
#include "data/study/study.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Source of seeds for new runs: each run that it describes differs from all earlier runs, since a
/// repetition of an earlier run would confirm nothing.
class FreshSeeds {
  public:
    /// @param seed the user's seed, from which the seeds of the runs follow
    explicit FreshSeeds(std::uint64_t seed) : seed_(seed) {}

    /// Parameters of new runs of the study's grains at `states`, in this order, none of which is
    /// among the runs `known`.
    std::vector<dem::RunParameters> runs_at(const std::vector<FlowState>& states,
                                            const Study& study, const Fidelity& fidelity,
                                            const std::vector<dem::RunResult>& known);

  private:
    std::uint64_t seed_;
    /// Number of the next run, from which its seed follows.
    std::uint64_t next_ = std::uint64_t{1} << 32;
};

/// Returns those of `runs` that can train an emulator (`emulated::usable`), and adds a note for the
/// user to `notes` for each of the others.
std::vector<dem::RunResult> usable_of(const std::vector<dem::RunResult>& runs,
                                      std::vector<std::string>& notes);

/// Probability (p-value) of a difference between the stress ratios and solid fractions of `fresh`
/// runs and the predictions of an emulator that was not trained on them, at least as large as
/// observed [1]; 1 without runs.
double agreement(const Emulator& emulator, const std::vector<dem::RunResult>& fresh);

/// Significance level [1]: below this p-value (`agreement`) new runs disagree with the emulator's
/// predictions.
constexpr double disagreement = 0.01;

}  // namespace pendular
