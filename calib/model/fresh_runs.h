#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"
#include "data/study/study.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Source of random seeds for new simulation runs. A new run with the parameters of an earlier run
/// needs another seed, since it would otherwise only repeat the result of the earlier run.
class FreshSeeds {
  public:
    /// @param seed seed of the user, from which the seeds of all runs follow
    explicit FreshSeeds(std::uint64_t seed) : seed_(seed) {}

    /// Returns the parameters of a new simulation run of the study's grains at each of `states`, in
    /// the order of `states`. The seed of each new run makes the run differ from all runs `known`.
    std::vector<dem::RunParameters> runs_at(const std::vector<FlowState>& states,
                                            const Study& study, const Fidelity& fidelity,
                                            const std::vector<dem::RunResult>& known);

  private:
    std::uint64_t seed_;
    /// Number of the next new run, from which the seed of the run follows.
    std::uint64_t next_ = std::uint64_t{1} << 32;
};

/// Returns the simulation runs among `runs` on which an emulator can be trained
/// (`emulated::usable`). For each unusable run, the function appends a message to `notes` that
/// tells the user why the run is not used.
std::vector<dem::RunResult> usable_of(const std::vector<dem::RunResult>& runs,
                                      std::vector<std::string>& notes);

/// Returns the p value [1] of a chi-squared test of an emulator against the simulation runs
/// `fresh`, on which the emulator was not trained: probability of a chi2 of all stress ratios and
/// solid fractions at least as large as observed if the emulator is right. The p value is 1 if
/// there are no runs.
double agreement(const Emulator& emulator, const std::vector<dem::RunResult>& fresh);

/// Significance level [1] of the test whether new simulation runs agree with an emulator. If the p
/// value (`agreement`) is below the level, the runs disagree with the emulator's predictions.
constexpr double disagreement = 0.01;

}  // namespace pendular
