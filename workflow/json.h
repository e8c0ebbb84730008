#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "workflow/run_json.h"

namespace pendular {

/// JSON of a study's measurements, which `pendular import` prints: every reading, every excluded
/// range of rows with its reason, the scatter between replicates, doubts and notes.
nlohmann::ordered_json to_json(const Measurements& measurements);

/// JSON of a comparison of model and measurement, with its cohesion lines and the tests of its
/// residuals, which `pendular compare` prints and writes to out/compare.json.
nlohmann::ordered_json to_json(const Comparison& comparison, const std::vector<CohesionLine>& lines,
                               const WhereItFails& where);

/// Writes a JSON object to a file, with the key `"format"` first (data/files/json_text.h). The text
/// goes to a temporary file that is then renamed, so that an earlier file survives a full disk.
/// @throws std::runtime_error where the file cannot be written
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);

}  // namespace pendular
