#pragma once

#include <vector>

#include "calib/emulator/query.h"
#include "data/study/study.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Simulation runs that exist before a calibration and on which the emulator is trained, with
/// hyperparameters of the emulator that were fitted in advance.
struct KnownRuns {
    /// Training runs of the emulator. If the list is empty and `may_simulate` is true, a
    /// calibration first simulates dry runs.
    std::vector<dem::RunResult> runs;
    /// Hyperparameters of the emulator's Gaussian processes for each observable. If an observable
    /// has no entry, its hyperparameters are fitted to `runs`.
    EmulatorHyperparameters hyperparameters;
    /// Whether a calibration may simulate new runs in addition to the training runs `runs`.
    bool may_simulate = true;
};

/// Returns the runs among `runs` on which the emulator for a study can be trained. Each returned
/// run is usable (`emulated::usable`) and has only effects that the study lists. The run has at
/// least 1000 grains or, if fewer, the number of grains in the settings `fidelity`. The Poisson
/// ratios of the run and of the study's grains differ by at most 0.1. A wet run has the formula for
/// the bridge force that the study states.
std::vector<dem::RunResult> runs_serving(const Study& study, const Fidelity& fidelity,
                                         const std::vector<dem::RunResult>& runs);

}  // namespace pendular
