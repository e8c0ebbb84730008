#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "app/options.h"
#include "sim/runs/store/run_store.h"
#include "workflow/fit_runs.h"

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

}  // namespace pendular::app
