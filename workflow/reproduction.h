#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "analysis/reproduction/published_numbers.h"
#include "sim/runs/fidelity.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

/// Numbers of Badetti et al. (2018), compared with the same numbers from simulations.
class Reproduction {
  public:
    /// Reads the runs of the atlas, the runs at the paper's stiffness that come with the program,
    /// and the runs of a store.
    /// @param store user's file of runs; may be null
    /// @throws InputError where there are too few runs
    Reproduction(const Fidelity& fidelity, const RunStore* store);
    Reproduction(const Reproduction&) = delete;
    Reproduction& operator=(const Reproduction&) = delete;

    const PaperStudy& study() const { return *study_; }
    const std::vector<ScoreboardRow>& rows() const { return rows_; }
    /// Number of rows that agree.
    std::size_t agreeing() const;
    /// Parameters of runs at the states of the paper's grid that have not been simulated, with the
    /// fidelity's number of grains and stiffness number.
    std::vector<dem::RunParameters> missing_runs() const;

  private:
    Fidelity fidelity_;
    std::unique_ptr<const Emulator> emulator_;
    std::unique_ptr<const PaperStudy> study_;
    std::vector<ScoreboardRow> rows_;
};

/// JSON of a reproduction, as `pendular reproduce` prints it: each published number or range with
/// the simulated number and whether they agree.
nlohmann::ordered_json to_json(const Reproduction& reproduction);

}  // namespace pendular
