#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/misfit/believable.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"

namespace pendular {

/// JSON that `calibrate` prints and `out/fit.json` holds.
nlohmann::ordered_json to_json(const Calibration& calibration, const Comparison& comparison);

/// Writes FOLDER/fit.json, and beside it FOLDER/fit_runs.csv with the runs that the atlas lacks.
/// @return what fit.json holds
/// @throws std::runtime_error where it cannot be written
nlohmann::ordered_json write_calibration(const std::filesystem::path& folder,
                                         const Calibration& calibration,
                                         const Comparison& comparison, const Belief& belief);

/// A calibration back from `out/fit.json`, its predictions excepted; its grains, liquid, model and
/// readings (dry first) come from the study and must be those that were fitted. Files of versions
/// that wrote whole runs into it are read too.
/// @throws InputError where the file is missing, malformed, of another format, or was made from
///         others, and where a run it rests on is nowhere any more
Calibration read_calibration(const std::filesystem::path& file, const ResolvedStudy& study,
                             const std::vector<Reading>& readings);

}  // namespace pendular
