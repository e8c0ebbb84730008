#pragma once

#include <cstddef>
#include <optional>

#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Returns the earlier simulation runs that can train an emulator (which interpolates simulations)
/// for a study: first the runs of the atlas (the simulations supplied with Pendular), then the runs
/// of the store (the user's file of simulations), latest first. A run can train the emulator if it
/// was made with the present version of the simulated physics (`dem::physics_version`), and if its
/// effects, number of grains, Poisson ratio and bridge force law suit the study (`runs_serving`).
/// If more than `most_known` runs can train the emulator, the oldest runs of the store are left out
/// and the listener receives a note. Empty if fewer than 20 runs can train the emulator.
/// @param store user's file of simulations; null: only the atlas is used
/// @throws InputError if the atlas cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Returns the hyperparameters (amplitudes and lengths) of the emulator's Gaussian processes from
/// the file beside the atlas (the simulations supplied with Pendular). Empty if the file does not
/// exist.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of runs on which an emulator (which interpolates simulations) is trained. The
/// time of training is proportional to the cube of the number of runs, and is some seconds for
/// `most_known` runs.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
