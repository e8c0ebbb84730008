#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/options.h"
#include "sim/runs/store/run_store.h"

namespace pendular::app {

/// The store of runs for a command that only adds to it. Null, which is said on standard error,
/// where its standard place cannot be written: the command then goes on without.
/// @throws InputError, std::runtime_error as RunStore
std::unique_ptr<RunStore> open_store(const CommonOptions& options);

/// Number of a stored run.
/// @throws InputError if it is none
std::int64_t run_number(const std::string& word);

}  // namespace pendular::app
