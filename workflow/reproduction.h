#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "analysis/reproduction/published_numbers.h"
#include "sim/runs/run_settings.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Comparison of the numbers that Badetti et al. (2018) publish with those of simulations.
class Reproduction {
  public:
    /// Compares the published numbers with runs of the atlas and of a store (null: only the atlas).
    /// @param fidelity sets the smallest number of grains (at most 1000) of the runs that are used,
    ///        and the settings of `missing_runs`
    /// @throws InputError if there are too few runs
    Reproduction(const Fidelity& fidelity, const RunStore* store);
    Reproduction(const Reproduction&) = delete;
    Reproduction& operator=(const Reproduction&) = delete;

    const Emulator& emulator() const { return *emulator_; }
    const PaperStudy& study() const { return *study_; }
    const std::vector<ScoreboardRow>& rows() const { return rows_; }
    /// Returns how many published numbers or ranges agree with the simulated numbers.
    std::size_t agreeing() const;
    /// Returns the parameters of one run for each state of the published simulations that has not
    /// been simulated yet, with grains, strain and stiffness number of the fidelity.
    std::vector<dem::RunParameters> missing_runs() const;

  private:
    Fidelity fidelity_;
    std::unique_ptr<const Emulator> emulator_;
    std::unique_ptr<const PaperStudy> study_;
    std::vector<ScoreboardRow> rows_;
};

}  // namespace pendular
