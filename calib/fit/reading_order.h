#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Readings of a study in the order of a calibration: dry ones first.
std::vector<Reading> dry_first(const Measurements& measurements);

/// Number of dry readings.
std::size_t dry_count(const std::vector<Reading>& readings);

/// Readings [from, to).
std::vector<Reading> part(const std::vector<Reading>& readings, std::size_t from, std::size_t to);

}  // namespace pendular
