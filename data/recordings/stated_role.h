#pragma once

#include <string>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Returns the role that the user states for an interval by its number, its name or the name of its
/// test; empty if there is none.
std::string stated_role(const Block& block, const FileFormat& format);

}  // namespace pendular
