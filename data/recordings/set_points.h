#pragma once

#include <vector>

#include "data/files/formats/block_file.h"
#include "data/recordings/findings/file_finding.h"

namespace pendular {

/// Adds a finding for each quantity whose measured column, such as "Normal Force", does not follow
/// its column of set points, such as "Normal Force set". Stretches of at least 20 rows with a
/// constant set point other than 0 are examined. In each stretch, the median of the measured values
/// in the second half is compared with the set point. The column does not follow if the median and
/// the set point differ by more than 2 % and by more than two steps of the resolution.
void check_set_points(const BlockFile& file, std::vector<FileFinding>& findings);

}  // namespace pendular
