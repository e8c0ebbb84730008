#pragma once

#include <map>
#include <string>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Returns the files of the study that a virtual laboratory writes: study.toml and the recordings.
/// The key of an element is the name of a file, the value is the text of the file. The files
/// contain neither the true friction coefficient nor the true effects, which a calibration has to
/// find.
std::map<std::string, std::string> study_files(const LabResult& result);

}  // namespace pendular
