#pragma once

#include <map>
#include <string>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns the files of the study that a virtual laboratory writes, its recordings and study.toml,
/// as text by file name. The files do not contain the true friction and the effects.
std::map<std::string, std::string> study_files(const LabResult& result);

}  // namespace pendular
