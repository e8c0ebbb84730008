#pragma once

#include <vector>

#include "calib/emulator/query.h"
#include "data/study/study.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Simulation runs from which a calibration starts: training runs of the emulator, with
/// hyperparameters (amplitudes and lengths of its Gaussian processes) that were fitted to them
/// before.
struct KnownRuns {
    /// Training runs. If there are none and `orders_more` is true, a calibration first simulates
    /// dry runs.
    std::vector<dem::RunResult> runs;
    /// Hyperparameters of the emulator's Gaussian processes, by observable; missing ones are fitted
    /// to `runs`.
    EmulatorHyperparameters hyperparameters;
    /// Whether a calibration may simulate new runs in addition to the earlier ones.
    bool orders_more = true;
};

/// Returns the runs that can train an emulator for a study. Such a run is usable
/// (`emulated::usable`), has only effects that the study lists, at least 1000 grains or as many as
/// the settings `fidelity`, and a Poisson ratio within 0.1 of that of the study's grains (0.1
/// changes the ratio of tangential to normal stiffness by less than a tenth). A wet run has the
/// study's formula of the bridge force.
std::vector<dem::RunResult> runs_serving(const Study& study, const Fidelity& fidelity,
                                         const std::vector<dem::RunResult>& runs);

}  // namespace pendular
