#pragma once

#include <vector>

#include "data/recordings/wall_locus.h"
#include "data/recordings/yield_locus.h"

namespace pendular {

/// Returns remarks on the points of a file: on those that are impossible (`impossible_points`), on
/// loci in which a load returns before each lower one, as that of preshears does, and on lines that
/// fall.
std::vector<Remark> check_points(const BlockFile& file, const std::vector<IntervalSeries>& series,
                                 const std::vector<YieldLocus>& loci,
                                 const std::vector<WallLocus>& walls);

}  // namespace pendular
