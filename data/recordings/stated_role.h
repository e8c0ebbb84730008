#pragma once

#include <string>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Returns the role that the user states for an interval by the interval's number, the interval's
/// name or the name of the interval's test. The text is empty if the user states no role.
std::string stated_role(const Block& block, const FileFormat& format);

}  // namespace pendular
