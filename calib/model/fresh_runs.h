#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"
#include "data/study/study.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Source of random seeds for new simulation runs. The seeds make each new run differ from all
/// earlier runs. A run with the parameters and the seed of an earlier run would only repeat the
/// result of the earlier run.
class FreshSeeds {
  public:
    /// @param seed seed of the user, from which the seeds of all runs follow
    explicit FreshSeeds(std::uint64_t seed) : seed_(seed) {}

    /// Returns the parameters of a new run of the study's grains at each of `states`, in the order
    /// of `states`. No new run equals one of the runs `known`.
    std::vector<dem::RunParameters> runs_at(const std::vector<FlowState>& states,
                                            const Study& study, const Fidelity& fidelity,
                                            const std::vector<dem::RunResult>& known);

  private:
    std::uint64_t seed_;
    /// Number of the next new run, from which the seed of the run follows.
    std::uint64_t next_ = std::uint64_t{1} << 32;
};

/// Returns those of `runs` on which an emulator can be trained (`emulated::usable`). For each other
/// run, the function appends a sentence to `notes` that tells the user why the run is not used.
std::vector<dem::RunResult> usable_of(const std::vector<dem::RunResult>& runs,
                                      std::vector<std::string>& notes);

/// Returns the p value [1] of the agreement between the runs `fresh` and an emulator that was not
/// trained on the runs: the probability that chance makes chi2 of the stress ratios and solid
/// fractions at least as large as observed. The p value is 1 if there are no runs.
double agreement(const Emulator& emulator, const std::vector<dem::RunResult>& fresh);

/// Limit of the p value of the agreement between new runs and an emulator (`agreement`) [1]. If the
/// p value is below the limit, the runs count as different from the emulator's predictions.
constexpr double disagreement = 0.01;

}  // namespace pendular
