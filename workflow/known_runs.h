#pragma once

#include <cstddef>
#include <optional>

#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Returns the earlier simulation runs that can train an emulator (which interpolates simulations)
/// for a study. The runs of the atlas (the simulations supplied with Pendular) come first, then the
/// runs of `store`, latest first. Each run has the present physics version (`dem::physics_version`)
/// and suits the study (`runs_serving`). If there are more than `most_known` runs, the oldest runs
/// of `store` are left out and the listener receives a note. Empty if there are fewer than 20 such
/// runs.
/// @param store user's file of simulations; null: only the atlas is used
/// @throws InputError if the atlas cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Returns the hyperparameters (amplitudes, correlation lengths and noise) of the emulator's
/// Gaussian processes from the file beside the atlas (the simulations supplied with Pendular).
/// Empty if the file does not exist.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of runs on which an emulator (which interpolates simulations) is trained. The
/// time of training is proportional to the cube of the number of runs, and is some seconds for
/// `most_known` runs.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
