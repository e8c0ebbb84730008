#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Whether two readings are replicates: same liquid content, normal stress and inertial number
/// within 2 %.
bool are_replicates(const Reading& a, const Reading& b);

/// Readings of the same condition as places among `readings`, in their order.
std::vector<std::vector<std::size_t>> replicate_groups(const std::vector<Reading>& readings);

}  // namespace pendular
