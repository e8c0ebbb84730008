#pragma once

#include <nlohmann/json_fwd.hpp>

#include "data/recordings/file_view.h"
#include "data/recordings/measurements.h"

namespace pendular {

/// Returns the JSON of a study's measurements in SI units, as `pendular import STUDY --json` writes
/// it.
nlohmann::ordered_json to_json(const Measurements& measurements);

/// Returns the JSON of a file of measurements, as `pendular import FILE --json` writes it. Numbers
/// are in SI units, angles in rad.
nlohmann::ordered_json to_json(const FileView& view);

}  // namespace pendular
