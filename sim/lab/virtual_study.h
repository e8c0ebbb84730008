#pragma once

#include <map>
#include <string>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns the files that a virtual laboratory writes, text by name: study.toml and the recordings.
/// They contain neither the true friction coefficient nor the true effects, which a calibration has
/// to find.
std::map<std::string, std::string> study_files(const LabResult& result);

}  // namespace pendular
