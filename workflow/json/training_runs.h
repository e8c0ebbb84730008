#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "data/input_error.h"
#include "sim/dem/run.h"
#include "sim/runs/store/run_store.h"

namespace pendular {

// Training runs: simulations on which the emulator of a result is trained. Every run of the store
// that suits a study trains its emulator, so that an unrelated simulation changes the last digits
// of a result. Each result therefore names its runs by their fingerprints (hashes of inputs and
// results), and can be repeated with these runs alone (option --runs-of). Most of the runs are in
// the atlas, the others in the store and, for a fit, in fit_runs.csv beside fit.json.

/// Training runs of an earlier result, in the order in which its emulator was trained on them.
struct TrainingRuns {
    std::vector<dem::RunResult> runs;
    /// Number of runs, the first ones of `runs`, that existed before the result. When the result is
    /// repeated, the others are simulated again, or found in the store.
    std::size_t began_with = 0;
};

/// Returns the JSON of training runs: `number`, `hash` (independent of the order of the runs),
/// `began_with` and `names`. The order of the names must be kept, since the rounding errors of the
/// emulator depend on it.
/// @param began_with number of runs that existed before the result; empty: all
nlohmann::ordered_json runs_json(const std::vector<dem::RunResult>& runs,
                                 std::optional<std::size_t> began_with = {});

/// Writes the training runs of a fit that are not in the atlas to FOLDER/fit_runs.csv. Removes the
/// file if the atlas contains all of `runs`.
/// @throws std::runtime_error if the file cannot be written
void write_own_runs(const std::filesystem::path& folder, const std::vector<dem::RunResult>& runs);

/// Returns the training runs that a fit names, from the atlas and from fit_runs.csv beside the fit.
/// @param json entry `runs` of the fit; in a fit of an earlier version, a list of fingerprints or
///        of whole runs
/// @throws InputError if a named run is neither in the atlas nor in fit_runs.csv
TrainingRuns named_runs(const nlohmann::ordered_json& json, const std::filesystem::path& fit_file);

/// Returns the training runs of a result that a command wrote as JSON, from the atlas, from `store`
/// (may be null) and from fit_runs.csv beside the result.
/// @throws InputError if the file names no runs, or if some of the runs are gone; the message says
///         how many
std::shared_ptr<const TrainingRuns> runs_of_result(const std::filesystem::path& result,
                                                   const RunStore* store);

}  // namespace pendular
