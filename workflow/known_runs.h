#pragma once

#include <cstddef>
#include <optional>

#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Returns the earlier runs that can train an emulator for a study: first those of the atlas (the
/// runs that come with the program), then those of the store, latest first. A run can be used if it
/// has no effects other than those that the study lists, enough grains, a similar Poisson ratio
/// and, if wet, the study's bridge force law (`runs_serving`). If more than `most_known` runs can
/// be used, the oldest runs of the store are left out and the listener receives a note. Empty where
/// fewer than 20 runs can be used.
/// @param store store, the user's file of runs; null: only the atlas is used
/// @throws InputError where the atlas cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Returns the hyperparameters (amplitudes and lengths) of the emulator's Gaussian processes from
/// the file beside the atlas, the runs that come with the program. Empty where this file does not
/// exist.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of training runs of an emulator. The time of training grows with the cube of the
/// number and is some seconds at this limit.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
