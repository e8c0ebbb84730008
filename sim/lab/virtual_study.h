#pragma once

#include <map>
#include <string>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns the files of the study that a virtual laboratory writes, its recordings and study.toml,
/// as texts by file name. The files state neither the true friction nor the effects that acted,
/// which a calibration has to find.
std::map<std::string, std::string> study_files(const LabResult& result);

}  // namespace pendular
