#pragma once

#include <filesystem>
#include <vector>

#include "calib/emulator/query.h"
#include "data/study/study.h"
#include "sim/dem/run.h"
#include "sim/runs/run_settings.h"

namespace pendular {

/// Name of the file, in the folder of an atlas, with the hyperparameters fitted to the atlas.
constexpr const char* hyperparameters_name = "emulator.csv";

/// Reads hyperparameters from a CSV table with a row for each observable: its name, then the
/// hyperparameters in the order of `Hyperparameters::names`.
/// @throws InputError, with line and column of the file, if the file cannot be read, has a wrong
///         number of columns, an unknown observable, or a value that is no number between 1e-15 and
///         1e15
EmulatorHyperparameters read_hyperparameters(const std::filesystem::path& file);
/// Writes hyperparameters to a CSV table that `read_hyperparameters` can read.
/// @throws InputError if the file is a symbolic link to a file outside of the folder of the link
/// @throws std::runtime_error if the file cannot be written
void write_hyperparameters(const std::filesystem::path& file,
                           const EmulatorHyperparameters& hyperparameters);

/// Runs that exist before a calibration and train the emulator, with its hyperparameters.
struct KnownRuns {
    /// Training runs. Without any, a calibration first simulates dry runs if `may_simulate` is
    /// true.
    std::vector<dem::RunResult> runs;
    /// Hyperparameters fitted in advance; those of other observables are fitted to `runs`.
    EmulatorHyperparameters hyperparameters;
    /// Whether a calibration may simulate new runs in addition to `runs`.
    bool may_simulate = true;
};

/// Returns the runs on which the emulator for a study can be trained. Each is usable
/// (`emulated::usable`) and has only effects that the study lists. It has at least 1000 grains or,
/// if fewer, the number of grains in `fidelity`. Its Poisson ratio differs from that of the study
/// by at most 0.1. A wet run has the study's formula for the bridge force.
std::vector<dem::RunResult> runs_serving(const Study& study, const Fidelity& fidelity,
                                         const std::vector<dem::RunResult>& runs);

}  // namespace pendular
