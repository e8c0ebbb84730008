#pragma once

#include <vector>

#include "calib/emulator/query.h"
#include "data/study/study.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Training runs, with hyperparameters where they are known already.
struct KnownRuns {
    std::vector<dem::RunResult>
        runs;  ///< training runs; empty: the planner simulates a first design
    EmulatorHyperparameters hyperparameters;  ///< those missing are fitted
    bool orders_more = true;                  ///< whether runs may be ordered
};

/// Runs that can serve a study: of its bridge force, of no effects but those it lists, of as
/// many grains as the fidelity has or 1000, and of a Poisson ratio within 0.1 of its grains',
/// which changes the ratio of tangential to normal stiffness by less than a tenth.
std::vector<dem::RunResult> runs_serving(const Study& study, const Fidelity& fidelity,
                                         const std::vector<dem::RunResult>& runs);

}  // namespace pendular
