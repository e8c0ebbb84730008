#pragma once

#include <cstddef>
#include <optional>

#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Training runs for the grains of a study: the atlas and the runs of the store that can serve, the
/// latest ones where there are more than `most_known`, of which the listener is told; none where
/// they are too few.
/// @throws InputError for an atlas that cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Hyperparameters of the emulator that come with the atlas; empty without an atlas.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of training runs: the time of training grows with its cube and is some seconds
/// here.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
