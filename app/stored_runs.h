#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "app/options.h"
#include "calib/emulated_simulation.h"
#include "sim/dem/simulation_error.h"
#include "sim/store/run_store.h"

namespace pendular::app {

/// The store of runs for a command that only adds to it. Null, which is said on standard error,
/// where its standard place cannot be written: the command then goes on without.
/// @throws InputError, std::runtime_error as RunStore
std::unique_ptr<RunStore> open_store(const CommonOptions& options);

/// What an emulator knows of the beads of a study: the runs that come with the program and those of
/// the store that can serve, the latest of them where there are more than `most_known`, which is
/// said on standard error; none where they are too few to begin with.
/// @throws InputError for an atlas that cannot be read
std::optional<KnownRuns> known_runs(const Study& study, const Fidelity& fidelity,
                                    const RunStore* store);

/// Time grows with the cube of their number: so many take some seconds.
constexpr std::size_t most_known = 1500;

/// What is said where work that keeps its runs is interrupted.
dem::Interrupted interrupted_with(const RunStore& store);

/// Number of a stored run.
/// @throws InputError if it is none
std::int64_t run_number(const std::string& word);

}  // namespace pendular::app
