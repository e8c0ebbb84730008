#pragma once

#include <cstddef>
#include <optional>

#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Returns the earlier runs that can train an emulator for a study: first those of the atlas (the
/// runs that come with the program), then those of the store, latest first. A run can train it if
/// it has no effects but those that the study lists, enough grains, a similar Poisson ratio and, if
/// wet, the study's bridge force law (`runs_serving`). Beyond `most_known` runs, the oldest runs of
/// the store are left out and the listener is informed. Empty where fewer than 20 runs can be used.
/// @param store store, the user's file of runs; null: none
/// @throws InputError where the atlas cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Returns the hyperparameters (amplitudes and lengths) of the emulator's Gaussian processes from
/// the file beside the atlas, the runs that come with the program. Empty where there is no such
/// file.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of training runs of an emulator. The time of training grows with the cube of the
/// number and is some seconds at this limit.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
