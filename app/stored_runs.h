#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/options.h"
#include "sim/runs/store/run_store.h"

namespace pendular::app {

/// Opens the user's store of runs for a command that can do without a store. Returns null, with a
/// note on standard error, where the default folder of the store cannot be written.
/// @throws InputError for a file that is not a store, is corrupt or is from a newer version
/// @throws std::runtime_error where a store that the user named cannot be written
std::unique_ptr<RunStore> open_store(const CommonOptions& options);

/// Number of a stored run, parsed from a word of the command line.
/// @throws InputError where the word is not a whole number
std::int64_t run_number(const std::string& word);

}  // namespace pendular::app
