#pragma once

#include <cstddef>
#include <optional>

#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Returns the training runs for the emulator of a study: the runs of the atlas, then the runs of
/// the store, latest first, that can serve the study's grains. Beyond `most_known` runs, the oldest
/// of the store are left out and the listener is informed. Empty where fewer than 20 runs serve.
/// @param store user's file of runs; may be null
/// @throws InputError where the atlas cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Hyperparameters of the emulator that come with the atlas; empty where there is no atlas.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of training runs. The time of training grows with the cube of the number and is
/// some seconds at this limit.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
