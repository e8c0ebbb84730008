#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "app/options.h"
#include "sim/runs/store/run_store.h"

namespace pendular::app {

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
