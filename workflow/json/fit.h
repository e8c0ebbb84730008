#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/ladder.h"
#include "analysis/misfit/believable.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "sim/catalogue/resolved_study.h"

namespace pendular {

/// Returns the JSON of a calibration with its comparison, as written to fit.json.
nlohmann::ordered_json to_json(const Calibration& calibration, const Comparison& comparison,
                               const Belief& belief);

/// Writes FOLDER/fit.json, and FOLDER/fit_runs.csv with the training simulations that the atlas
/// does not contain.
/// @throws std::runtime_error if a file cannot be written
void write_calibration(const std::filesystem::path& folder, const Calibration& calibration,
                       const Comparison& comparison, const Belief& belief);

/// Reads a calibration from a fit.json, without the predictions of the readings. Grains, liquid,
/// model and direct measurements come from `study`, which must be the study that was fitted; the
/// training simulations from the atlas and from fit_runs.csv in the folder of `file`.
/// @param readings readings of the study, dry readings first
/// @throws InputError if the file is missing, malformed or of another format, if the study's
///         readings, direct measurements, grains, liquid or model have changed since the fit, or if
///         a training run is not found
Calibration read_calibration(const std::filesystem::path& file, const ResolvedStudy& study,
                             const std::vector<Reading>& readings);

/// Returns the JSON of one ladder step. Relative RMS errors are in %.
nlohmann::ordered_json to_json(const LadderStep& ladder_step);

/// Reads a ladder from a file such as ladder.json. Empty if the file does not exist.
/// @throws InputError if the file exists but is incomplete, is not in the format of a ladder, or
///         contains no ladder
Ladder read_ladder(const std::filesystem::path& file);

/// Writes a ladder to a file such as ladder.json. If writing fails, an earlier file is unchanged.
/// @throws std::runtime_error if the file cannot be written
void write_ladder(const std::filesystem::path& file, const Ladder& ladder);

}  // namespace pendular
