#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/reproduction/published_numbers.h"
#include "sim/runs/fidelity.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Comparison of the numbers that Badetti et al. (2018) publish with the same numbers from
/// simulations.
class Reproduction {
  public:
    /// Compares the published numbers with the runs of the atlas (the runs that come with the
    /// program) and of a store (the user's file of runs).
    /// @param store store; null: only the atlas is used
    /// @throws InputError where there are too few runs
    Reproduction(const Fidelity& fidelity, const RunStore* store);
    Reproduction(const Reproduction&) = delete;
    Reproduction& operator=(const Reproduction&) = delete;

    const PaperStudy& study() const { return *study_; }
    const std::vector<ScoreboardRow>& rows() const { return rows_; }
    /// Number of published numbers or ranges that agree with the simulated ones.
    std::size_t agreeing() const;
    /// Parameters of the runs that are still to be simulated: one for each published state without
    /// an earlier run. Number of grains and stiffness number are those of the fidelity, the set of
    /// simulation settings.
    std::vector<dem::RunParameters> missing_runs() const;

  private:
    Fidelity fidelity_;
    std::unique_ptr<const Emulator> emulator_;
    std::unique_ptr<const PaperStudy> study_;
    std::vector<ScoreboardRow> rows_;
};

/// JSON of a reproduction, as `pendular reproduce --json` writes it: each number or range that
/// Badetti et al. (2018) publish, with the simulated number and whether they agree.
nlohmann::ordered_json to_json(const Reproduction& reproduction);

}  // namespace pendular
