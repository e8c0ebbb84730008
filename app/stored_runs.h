#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/options.h"
#include "sim/runs/store/run_store.h"

namespace pendular::app {

/// Opens the user's store, the SQLite file that keeps simulations. If the user named no store and
/// the folder of the default store cannot be written, prints a note on standard error and returns
/// null.
/// @throws InputError if the file is not a store, is corrupt or is from a newer version of Pendular
/// @throws std::runtime_error if a store that the user named cannot be written
std::unique_ptr<RunStore> open_store(const CommonOptions& options);

/// Converts a word of the command line to the number of a stored simulation. Does not check that
/// the store (the user's file of simulations) has a simulation with this number.
/// @throws InputError if the word is not a whole number
std::int64_t run_number(const std::string& word);

}  // namespace pendular::app
