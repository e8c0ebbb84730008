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

/// JSON array of the fingerprints that name the training runs of an emulator. The order is that of
/// `runs` and must be kept, since the emulator's rounding errors depend on it.
nlohmann::ordered_json run_names(const std::vector<dem::RunResult>& runs);

/// Writes those of `runs`, a fit's training runs, that the atlas (runs that come with the program)
/// lacks to FOLDER/fit_runs.csv. Removes that file where the atlas has all of them.
/// @throws std::runtime_error where the file cannot be written
void write_own_runs(const std::filesystem::path& folder, const std::vector<dem::RunResult>& runs);

/// Returns the training runs that a fit file names, from the atlas (runs that come with the
/// program) and from fit_runs.csv beside the fit file. Runs that the fit file contains whole, as
/// earlier versions wrote them, are returned unchanged.
/// @param names fingerprints, or whole runs, as in the fit file
/// @throws InputError where a named run is neither in the atlas nor in fit_runs.csv; the message
///         says what to do
std::vector<dem::RunResult> named_runs(const nlohmann::ordered_json& names,
                                       const std::filesystem::path& fit_file);

}  // namespace pendular
