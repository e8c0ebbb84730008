#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"
#include "data/study/study.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Source of random seeds for new simulation runs. Each new run differs from all earlier runs,
/// since repeating an earlier run would give the identical result.
class FreshSeeds {
  public:
    /// @param seed seed of the user, from which the seeds of all runs follow
    explicit FreshSeeds(std::uint64_t seed) : seed_(seed) {}

    /// Returns the parameters of a new run of the study's grains at each of `states`, in this
    /// order. None of the new runs is among the runs `known`.
    std::vector<dem::RunParameters> runs_at(const std::vector<FlowState>& states,
                                            const Study& study, const Fidelity& fidelity,
                                            const std::vector<dem::RunResult>& known);

  private:
    std::uint64_t seed_;
    /// Number of the next run to simulate, from which the seed of this run follows.
    std::uint64_t next_ = std::uint64_t{1} << 32;
};

/// Returns the runs that can train an emulator (`emulated::usable`). For each other run, a sentence
/// for the user that states why the run is not used is appended to `notes`.
std::vector<dem::RunResult> usable_of(const std::vector<dem::RunResult>& runs,
                                      std::vector<std::string>& notes);

/// p value of the agreement between `fresh` runs and an emulator that was not trained on them [1]:
/// the probability that chance makes chi2 of the stress ratios and solid fractions at least as
/// large as observed. 1 if there are no runs.
double agreement(const Emulator& emulator, const std::vector<dem::RunResult>& fresh);

/// p value of `agreement` [1] below which new runs count as different from the emulator's
/// predictions.
constexpr double disagreement = 0.01;

}  // namespace pendular
