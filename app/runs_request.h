#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/runs/store/run_store.h"

namespace pendular::app {

/// Arguments of an action of `pendular runs`, such as "show 12".
struct RunsRequest {
    CommonOptions common;
    /// Words that follow the name of the action on the command line.
    std::vector<std::string> words;
    /// SQL condition on the stored runs (--where; empty: all runs) and columns on the axes of a
    /// plot.
    std::string condition, x = "inertial_number", y = "stress_ratio";
    /// `atlas`: whether to read the runs of the atlas (which come with the program) instead of the
    /// user's store. `yes`: whether to remove runs without asking.
    bool atlas = false, yes = false;

    /// Opens the store of the runs to read: the user's store or, with --atlas, the runs of the
    /// atlas in memory, numbered from 1.
    /// @throws InputError where the store or the atlas does not exist
    std::unique_ptr<RunStore> source() const;
    /// Runs of `source` for which the condition of --where holds.
    /// @throws InputError where the store or the atlas does not exist, and for a wrong condition
    std::vector<StoredRun> selected() const { return source()->select(condition); }
    /// Checks that the user did not give --atlas, for an action that changes the store.
    /// @throws InputError where --atlas was given
    void refuse_atlas(const std::string& action) const;
    /// Checks that at least `least` words follow the name of the action on the command line.
    /// @param what what the words must name, for the error message
    /// @throws InputError where fewer words follow
    void demand_words(std::size_t least, const std::string& what) const;
};

/// Returns the run of a store whose number the user typed.
/// @param store store that `RunsRequest::source` opened
/// @param word word of the command line that states the number
/// @throws InputError where the store has no run of this number, and where `word` is not a number
StoredRun numbered_run(const RunStore& store, const std::string& word);

}  // namespace pendular::app
