#pragma once

#include <vector>

#include "data/files/formats/block_file.h"
#include "data/recordings/findings/file_finding.h"

namespace pendular {

/// Adds findings on measured columns that do not follow their set points, such as "Normal Force"
/// beside "Normal Force set": one finding per quantity. Compared are the medians over the second
/// half of each stretch of at least 20 rows with a constant set point other than 0. They differ if
/// they are more than 2 % and more than two steps of the column's resolution apart.
void check_set_points(const BlockFile& file, std::vector<FileFinding>& findings);

}  // namespace pendular
