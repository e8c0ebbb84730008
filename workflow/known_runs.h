#pragma once

#include <cstddef>
#include <optional>

#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Returns the training runs for the emulator of a study: the runs of the atlas (runs that come
/// with the program), then those of the store, latest first, as far as they can serve the study
/// (`runs_serving`). Beyond `most_known` runs, the oldest runs of the store are left out and the
/// listener is informed. Empty where fewer than 20 runs serve.
/// @param store store, the user's file of runs; may be null
/// @throws InputError where the atlas cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Hyperparameters (lengths, amplitudes) of the emulator's Gaussian processes, from the file beside
/// the atlas; empty where there is no such file.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of training runs of an emulator. The time of training grows with the cube of the
/// number and is some seconds at this limit.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
