#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns the readings of a study in the order that a calibration uses. First come the dry
/// readings, then the wet readings, each in the order of `Measurements::readings`.
std::vector<Reading> dry_first(const Measurements& measurements);

/// Returns the number of dry readings (liquid content 0) among `readings`.
std::size_t dry_count(const std::vector<Reading>& readings);

/// Returns the readings with indices `from` to `to` - 1 of the list `readings`.
std::vector<Reading> part(const std::vector<Reading>& readings, std::size_t from, std::size_t to);

}  // namespace pendular
