#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "data/input_error.h"
#include "sim/dem/run.h"

namespace pendular {

// The runs that a fit rests on. A fit file names each by its fingerprint; the atlas has most of
// them, the others stand in a table beside the fit file.

/// Their fingerprints, in the order of the runs, which the emulator's rounding errors depend on.
nlohmann::ordered_json run_names(const std::vector<dem::RunResult>& runs);

/// Writes those that the atlas lacks to FOLDER/fit_runs.csv; none: removes that file.
/// @throws std::runtime_error where it cannot be written
void write_own_runs(const std::filesystem::path& folder, const std::vector<dem::RunResult>& runs);

/// The runs that a fit file names, from the atlas and from fit_runs.csv beside it; runs that stand
/// in the fit file whole, as older versions wrote them, are taken as they are.
/// @throws InputError where some of them are nowhere any more, with what to do
std::vector<dem::RunResult> named_runs(const nlohmann::ordered_json& names,
                                       const std::filesystem::path& fit_file);

}  // namespace pendular
