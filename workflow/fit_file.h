#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/misfit/believable.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"

namespace pendular {

/// JSON of a calibration and of its comparison with the readings, as in out/fit.json, without the
/// judgement (`Belief`) whether the fit can be believed.
nlohmann::ordered_json to_json(const Calibration& calibration, const Comparison& comparison);

/// Writes a calibration, its comparison with the readings and the judgement of it to
/// FOLDER/fit.json, and its training runs that the atlas (the runs that come with the program)
/// lacks to FOLDER/fit_runs.csv. Returns the content of fit.json.
/// @throws std::runtime_error where a file cannot be written
nlohmann::ordered_json write_calibration(const std::filesystem::path& folder,
                                         const Calibration& calibration,
                                         const Comparison& comparison, const Belief& belief);

/// Reads a calibration from a fit.json, without its predictions. Grains, liquid, model and direct
/// measurements are taken from `study`, which must be the study that was fitted. Files of earlier
/// versions, which contain whole runs, are read too.
/// @param readings readings of the study, dry readings first
/// @throws InputError where the file is missing, malformed or of another format, where the fit was
///         made from other readings, direct measurements, grains, liquid or model, and where a
///         training run is neither in the atlas nor in fit_runs.csv
Calibration read_calibration(const std::filesystem::path& file, const ResolvedStudy& study,
                             const std::vector<Reading>& readings);

}  // namespace pendular
