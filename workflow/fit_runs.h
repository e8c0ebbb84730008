#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "data/input_error.h"
#include "sim/dem/run.h"

namespace pendular {

// Training runs of a calibration. A fit file (fit.json) names each run by its fingerprint. Most of
// the runs are in the atlas, the runs that come with the program; the others are in the table
// fit_runs.csv beside the fit file.

/// JSON array with one name for each training run of an emulator, in the order of `runs`. The name
/// of a run is its fingerprint, a hash of its inputs and results. The order must be kept, since the
/// emulator's rounding errors depend on it.
nlohmann::ordered_json run_names(const std::vector<dem::RunResult>& runs);

/// Writes the training runs of a fit that are not in the atlas (the runs that come with the
/// program) to FOLDER/fit_runs.csv. Removes this file where the atlas contains all of `runs`.
/// @throws std::runtime_error where the file cannot be written
void write_own_runs(const std::filesystem::path& folder, const std::vector<dem::RunResult>& runs);

/// Returns the training runs that a fit file names, in the order of `names`. They are read from the
/// atlas (the runs that come with the program) and from fit_runs.csv beside the fit file.
/// @param names JSON array of the fingerprints (hashes) of the runs; files of earlier versions
///        contain whole runs instead, which are returned as they are
/// @throws InputError where a named run is neither in the atlas nor in fit_runs.csv
std::vector<dem::RunResult> named_runs(const nlohmann::ordered_json& names,
                                       const std::filesystem::path& fit_file);

}  // namespace pendular
