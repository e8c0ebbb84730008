#pragma once

#include <map>
#include <string>

#include "sim/lab/virtual_lab.h"

namespace pendular {

/// Files of the study that a virtual laboratory writes, recordings and study.toml, by name. They do
/// not contain the truth.
std::map<std::string, std::string> study_files(const LabResult& result);

}  // namespace pendular
