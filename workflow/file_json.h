#pragma once

#include <nlohmann/json_fwd.hpp>

#include "data/recordings/file_view.h"

namespace pendular {

/// JSON of what the program understands of a file of measurements by itself, which `pendular import
/// FILE` prints: layout, encoding, columns with units, intervals with roles, findings of the checks
/// and yield loci. SI units; angles in rad.
nlohmann::ordered_json to_json(const FileView& view);

}  // namespace pendular
