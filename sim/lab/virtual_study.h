#pragma once

#include <map>
#include <string>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns the files of the study that a virtual laboratory writes, its recordings and study.toml:
/// text of each file by file name. The files contain neither the true friction nor the true
/// effects, which a calibration has to find.
std::map<std::string, std::string> study_files(const LabResult& result);

}  // namespace pendular
