#pragma once

#include <filesystem>

#include "reports/output.h"
#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns what `pendular virtual-lab` says of the recordings that it wrote to `folder`.
Output lab_output(const LabResult& result, const std::filesystem::path& folder);

}  // namespace pendular
