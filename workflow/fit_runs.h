#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "data/input_error.h"
#include "sim/dem/run.h"

namespace pendular {

// Training runs of a calibration: simulations on which its emulator is trained. A fit file
// (fit.json) names each run by its fingerprint, a hash of inputs and results. Most of the runs are
// in the atlas (the simulations supplied with Pendular). The other runs are in the table
// fit_runs.csv beside the fit file.

/// Returns a JSON array with the names of `runs`, the simulations on which an emulator is trained,
/// in the order of `runs`. The name of a run is its fingerprint, a hash of the run's inputs and
/// results. The order must be kept, since the emulator's rounding errors depend on the order.
nlohmann::ordered_json run_names(const std::vector<dem::RunResult>& runs);

/// Writes the training runs of a fit (simulations on which its emulator is trained) that are not in
/// the atlas (the simulations supplied with Pendular) to FOLDER/fit_runs.csv. Removes
/// FOLDER/fit_runs.csv if the atlas contains all of `runs`.
/// @throws std::runtime_error if the file cannot be written
void write_own_runs(const std::filesystem::path& folder, const std::vector<dem::RunResult>& runs);

/// Returns the training runs (simulations on which an emulator is trained) that a fit file names,
/// in the order of `names`. The runs are read from the atlas (the simulations supplied with
/// Pendular) and from fit_runs.csv beside the fit file.
/// @param names JSON array of the fingerprints (hashes) of the runs or, in a fit file of an earlier
///        version, of the runs themselves
/// @throws InputError if a named run is neither in the atlas nor in fit_runs.csv
std::vector<dem::RunResult> named_runs(const nlohmann::ordered_json& names,
                                       const std::filesystem::path& fit_file);

}  // namespace pendular
