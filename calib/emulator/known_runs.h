#pragma once

#include <vector>

#include "calib/emulator/query.h"
#include "data/study/study.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Simulation runs that exist before a calibration and train its emulator, with hyperparameters
/// (amplitudes and lengths of the emulator's Gaussian processes) that were fitted to the runs
/// before.
struct KnownRuns {
    /// Training runs. If the list is empty and `orders_more` is true, a calibration first simulates
    /// dry runs.
    std::vector<dem::RunResult> runs;
    /// Hyperparameters of the emulator's Gaussian processes, by observable; missing ones are fitted
    /// to `runs`.
    EmulatorHyperparameters hyperparameters;
    /// Whether a calibration may simulate new runs in addition to the earlier ones.
    bool orders_more = true;
};

/// Returns the runs that can train an emulator for a study. Each of them is usable
/// (`emulated::usable`) and has only effects that the study lists. It has at least 1000 grains, or
/// at least the number of grains in the settings `fidelity` if that is smaller. Its Poisson ratio
/// differs by at most 0.1 from that of the study's grains (0.1 changes the ratio of tangential to
/// normal stiffness by less than a tenth). If it is wet, it has the study's formula of the bridge
/// force.
std::vector<dem::RunResult> runs_serving(const Study& study, const Fidelity& fidelity,
                                         const std::vector<dem::RunResult>& runs);

}  // namespace pendular
