#pragma once

#include <cstddef>
#include <optional>

#include "calib/emulator/known_runs.h"
#include "data/study/study.h"
#include "sim/runs/store/run_store.h"
#include "workflow/listener.h"

namespace pendular {

/// Returns the earlier runs that can train an emulator for a study: the runs of the atlas, then the
/// runs of `store`, latest first. Each run has the present physics version (`dem::physics_version`)
/// and suits the study (`runs_serving`). If there are more than `most_known` runs, the oldest runs
/// of `store` are left out and the listener receives a note. Empty if there are fewer than 20 such
/// runs.
/// @param store null: only the atlas is used
/// @throws InputError if the atlas cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store, const Listener& listener = {});

/// Returns the hyperparameters from the file beside the atlas; empty if there is no file.
EmulatorHyperparameters atlas_hyperparameters();

/// Largest number of runs on which an emulator is trained. The time of training grows with the cube
/// of the number, and is some seconds for `most_known` runs.
constexpr std::size_t most_known = 1500;

}  // namespace pendular
