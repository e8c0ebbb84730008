#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/reproduction/published_numbers.h"
#include "sim/runs/fidelity.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Comparison of the numbers that Badetti et al. (2018) publish with the numbers that simulations
/// give.
class Reproduction {
  public:
    /// Compares the published numbers with numbers from the runs of the atlas (the simulations
    /// supplied with Pendular) and of a store (the user's file of simulations).
    /// @param fidelity simulation settings: they set the smallest number of grains (at most 1000)
    ///        of the runs that are used, and the settings of `missing_runs`
    /// @param store user's file of simulations; null: only the atlas is used
    /// @throws InputError if there are too few runs
    Reproduction(const Fidelity& fidelity, const RunStore* store);
    Reproduction(const Reproduction&) = delete;
    Reproduction& operator=(const Reproduction&) = delete;

    const Emulator& emulator() const { return *emulator_; }
    const PaperStudy& study() const { return *study_; }
    const std::vector<ScoreboardRow>& rows() const { return rows_; }
    /// Returns the number of published numbers or ranges that agree with the simulated numbers.
    std::size_t agreeing() const;
    /// Returns the parameters of the runs that are still to be simulated: one run for each state of
    /// the published simulations that has not been simulated yet. The number of grains, the strain
    /// and the stiffness number are those of the fidelity (set of simulation settings).
    std::vector<dem::RunParameters> missing_runs() const;

  private:
    Fidelity fidelity_;
    std::unique_ptr<const Emulator> emulator_;
    std::unique_ptr<const PaperStudy> study_;
    std::vector<ScoreboardRow> rows_;
};

/// Returns the JSON of a reproduction, as `pendular reproduce --json` writes it: each number or
/// range that Badetti et al. (2018) publish, the simulated numbers, and whether the simulated
/// numbers agree with the published number or range.
nlohmann::ordered_json to_json(const Reproduction& reproduction);

}  // namespace pendular
