#pragma once

#include <vector>

#include "calib/emulator/query.h"
#include "data/study/study.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Training runs of an emulator with those of its hyperparameters that were fitted before.
struct KnownRuns {
    /// Training runs. If empty, a calibration first simulates dry runs, if `orders_more`.
    std::vector<dem::RunResult> runs;
    EmulatorHyperparameters hyperparameters;  ///< by observable; missing ones are fitted
    bool orders_more = true;                  ///< whether the planner may request new simulations
};

/// Returns those of `runs` that can train an emulator for a study: they are usable
/// (`emulated::usable`), have no effects but those that the study lists, at least 1000 grains or as
/// many as `fidelity` (set of simulation settings), and a Poisson ratio within 0.1 of the study's
/// grains; wet runs have the study's bridge force law. A difference of 0.1 changes the ratio of
/// tangential to normal stiffness by less than a tenth.
std::vector<dem::RunResult> runs_serving(const Study& study, const Fidelity& fidelity,
                                         const std::vector<dem::RunResult>& runs);

}  // namespace pendular
