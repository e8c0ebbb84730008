#pragma once

#include <vector>

#include "data/reading.h"

namespace pendular {

/// Removes the readings of a recording that its faults spoil, and returns a remark on each: all of
/// a recording with a wrong or constant column, otherwise those of which more than 1 in 100 rows
/// contradict each other or are saturated, since the mean over the other rows may be biased.
/// @param faults decided remarks on the recording
std::vector<Remark> set_spoilt_aside(std::vector<Reading>& readings,
                                     const std::vector<Remark>& faults, int averaged_rows);

/// Removes the readings that decided remarks name (`impossible_reading`, `repeated_reading`).
void set_named_aside(std::vector<Reading>& readings, const std::vector<Remark>& remarks);

}  // namespace pendular
