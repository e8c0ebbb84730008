#pragma once

#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// Returns a fault for each quantity whose measured column, such as "Normal Force", does not follow
/// its column of set points, such as "Normal Force set". Over the second half of each stretch of at
/// least 20 rows with a constant set point other than 0, the median of the measured values must
/// agree with it within 2 % or two steps of the resolution.
std::vector<Remark> missed_set_points(const BlockFile& file);

}  // namespace pendular
