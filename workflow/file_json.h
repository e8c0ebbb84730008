#pragma once

#include <nlohmann/json_fwd.hpp>

#include "data/recordings/file_view.h"

namespace pendular {

/// JSON that describes a file of measurements, as `pendular import FILE` prints it: layout,
/// encoding, columns with units, intervals with roles, findings of the checks and yield loci. SI
/// units; angles in rad.
nlohmann::ordered_json to_json(const FileView& view);

}  // namespace pendular
