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
    /// Words that follow the name of the action on the command line.
    std::vector<std::string> words;
    /// SQL condition on the stored simulations (`condition`, option --where), and columns on the x
    /// axis and the y axis of a plot (`x`, `y`). An empty `condition` selects all stored
    /// simulations.
    std::string condition, x = "inertial_number", y = "stress_ratio";
    /// Whether to read the atlas (the simulations supplied with Pendular) instead of the user's
    /// store (`atlas`), and whether to remove simulations without asking (`yes`).
    bool atlas = false, yes = false;

    /// Opens the store of the simulations to read. The store is the user's file or, with --atlas, a
    /// copy of the atlas (the simulations supplied with Pendular) in memory, numbered from 1.
    /// @throws InputError if the store or the atlas does not exist
    std::unique_ptr<RunStore> source() const;
    /// Returns the simulations of `source` for which the condition of --where holds.
    /// @throws InputError if the store or the atlas does not exist, or if the condition is wrong
    std::vector<StoredRun> selected() const { return source()->select(condition); }
    /// Checks that the user did not give --atlas, for an action that changes the user's file of
    /// simulations.
    /// @throws InputError if --atlas was given
    void refuse_atlas(const std::string& action) const;
    /// Checks that at least `least` words follow the name of the action on the command line.
    /// @param what meaning of the missing words, for the error message
    /// @throws InputError if fewer words follow
    void demand_words(std::size_t least, const std::string& what) const;
};

/// Returns the simulation of a store whose number the user typed.
/// @param store store that `RunsRequest::source` opened
/// @param word word of the command line that states the number
/// @throws InputError if the store has no simulation of this number, or if `word` is not a number
StoredRun numbered_run(const RunStore& store, const std::string& word);

}  // namespace pendular::app
