#pragma once

#include <nlohmann/json_fwd.hpp>

#include "data/recordings/file_view.h"

namespace pendular {

/// Returns the JSON that describes a file of measurements, as `pendular import FILE --json` writes
/// it: layout, encoding, intervals with their roles and columns, faults, rows left out, and yield
/// loci. Numbers are in SI units, angles in rad.
nlohmann::ordered_json to_json(const FileView& view);

}  // namespace pendular
