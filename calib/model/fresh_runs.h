#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "calib/emulator/emulator.h"
#include "data/study/study.h"
#include "sim/runs/run_settings.h"

namespace pendular {

/// Source of random seeds for new simulation runs. A new run with the parameters of an earlier one
/// needs another seed: it would otherwise repeat the earlier result.
class FreshSeeds {
  public:
    /// @param seed seed of the user, from which the seeds of all runs follow
    explicit FreshSeeds(std::uint64_t seed) : seed_(seed) {}

    /// Returns the parameters of a new run of the study's grains at each of `states`, with seeds
    /// that differ from all runs `known` of equal parameters.
    std::vector<dem::RunParameters> runs_at(const std::vector<FlowState>& states,
                                            const Study& study, const Fidelity& fidelity,
                                            const std::vector<dem::RunResult>& known);

  private:
    std::uint64_t seed_;
    std::uint64_t next_ = std::uint64_t{1} << 32;  ///< number of the next run
};

/// Returns the runs that are `emulated::usable`. Appends to `notes` why others are not used.
std::vector<dem::RunResult> usable_of(const std::vector<dem::RunResult>& runs,
                                      std::vector<std::string>& notes);

/// Returns the p value [1] of a chi-squared test of an emulator against the stress ratios and solid
/// fractions of runs on which it was not trained; 1 if there are no runs.
double agreement(const Emulator& emulator, const std::vector<dem::RunResult>& fresh);

/// Significance level [1] of `agreement`, below which new runs disagree with the emulator. Chosen:
/// below 5 %, since each round of runs is tested and a false alarm costs a further round.
constexpr double disagreement = 0.01;

}  // namespace pendular
