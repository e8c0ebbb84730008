#pragma once

#include <map>
#include <string>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns the text of each file, by file name, of the study that a virtual laboratory writes: the
/// recordings and study.toml. The files contain neither the true friction nor the true effects,
/// which a calibration has to find.
std::map<std::string, std::string> study_files(const LabResult& result);

}  // namespace pendular
