#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/runs/store/run_store.h"
#include "workflow/json/training_runs.h"

namespace pendular::app {

/// Opens the user's store. If the user named none and the folder of the default store cannot be
/// written, prints a note on standard error and returns null.
/// @throws InputError if the file is not a store, is corrupt or is from a newer version of Pendular
/// @throws std::runtime_error if a store that the user named cannot be written
std::unique_ptr<RunStore> open_store(const CommonOptions& options);

/// Returns the training runs of the earlier result that --runs-of names; null without the option.
/// @param store the user's store; may be null
/// @throws InputError if the file names no runs, or if some of its runs are gone
std::shared_ptr<const TrainingRuns> training_runs(const CommonOptions& options,
                                                  const RunStore* store);

/// Converts a word of the command line to the number of a run, which the store need not have.
/// @throws InputError if the word is not a whole number
std::int64_t run_number(const std::string& word);

/// Arguments of an action of `pendular runs`, such as "show 12", which works on stored simulations.
struct RunsRequest {
    CommonOptions common;
    std::vector<std::string> words;  ///< words after the name of the action
    /// SQL condition of option --where, empty: all simulations; columns on the axes of a plot.
    std::string condition, x = "inertial_number", y = "stress_ratio";
    /// Whether to read the atlas instead of the store, and to remove simulations without asking.
    bool atlas = false, yes = false;

    /// Opens the simulations to read: the store or, with --atlas, a copy of the atlas in memory,
    /// numbered from 1.
    /// @throws InputError if the store or the atlas does not exist
    std::unique_ptr<RunStore> source() const;
    /// Returns the simulations of `source` for which the condition of --where holds.
    /// @throws InputError if the store or the atlas does not exist, or if the condition is wrong
    std::vector<StoredRun> selected() const { return source()->select(condition); }
    /// Checks that --atlas was not given, for an action that changes the store.
    /// @throws InputError if it was given
    void refuse_atlas(const std::string& action) const;
    /// Checks that at least `least` words follow the name of the action.
    /// @param what meaning of the missing words, for the error message
    /// @throws InputError if fewer words follow
    void demand_words(std::size_t least, const std::string& what) const;
};

/// Returns the simulation whose number the user typed.
/// @throws InputError if the store has no simulation of this number, or if `word` is not a number
StoredRun numbered_run(const RunStore& store, const std::string& word);

}  // namespace pendular::app
