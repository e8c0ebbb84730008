#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "workflow/run_json.h"

namespace pendular {

/// Returns the JSON of a study's measurements in SI units, as `pendular import STUDY --json` writes
/// it.
nlohmann::ordered_json to_json(const Measurements& measurements);

/// Returns the JSON of the comparison of readings and predictions, as written to out/compare.json.
nlohmann::ordered_json to_json(const Comparison& comparison, const std::vector<CohesionLine>& lines,
                               const WhereItFails& where);

/// Writes a JSON object to a file. The first key, "format", contains the version of the program's
/// JSON formats. The text goes to a temporary file, which is then renamed, so that an earlier file
/// is kept if the disk is full.
/// @throws std::runtime_error if the file cannot be written
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);

}  // namespace pendular
