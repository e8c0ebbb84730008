#pragma once

#include <vector>

#include "data/files/formats/block_file.h"
#include "data/recordings/findings/file_finding.h"

namespace pendular {

/// Adds a finding for each quantity whose measured column, such as "Normal Force", does not follow
/// its column of set points, such as "Normal Force set". The function examines stretches of at
/// least 20 rows with a constant set point other than 0. In the second half of a stretch, the
/// median of the measured values must agree with the set point within 2 % or within two steps of
/// the resolution.
void check_set_points(const BlockFile& file, std::vector<FileFinding>& findings);

}  // namespace pendular
