#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "analysis/diagnosis/where_it_fails.h"
#include "analysis/misfit/compare.h"
#include "calib/fit/calibration.h"
#include "workflow/run_json.h"

namespace pendular {

/// JSON that `import` prints: every reading, every exclusion with its reason, notes.
nlohmann::ordered_json to_json(const Measurements& measurements);

/// JSON that `compare` prints and `out/compare.json` holds.
nlohmann::ordered_json to_json(const Comparison& comparison, const std::vector<CohesionLine>& lines,
                               const WhereItFails& where);

/// Writes an object, `"format"` first (data/files/json_text.h), through a temporary file and a
/// rename, so that an earlier file survives a full disk.
/// @throws std::runtime_error where it cannot be written
void write_json(const std::filesystem::path& file, const nlohmann::ordered_json& json);

}  // namespace pendular
