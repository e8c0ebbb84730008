#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Whether two readings are replicates: equal liquid content, and normal stress, inertial number
/// and volume of grains in the cell equal within 2 %.
bool are_replicates(const Reading& a, const Reading& b);

/// Groups of replicates, as indices into `readings`: each reading joins the first group whose first
/// reading it replicates (`are_replicates`), else it begins a group of its own. Groups are sorted
/// by their first index.
std::vector<std::vector<std::size_t>> replicate_groups(const std::vector<Reading>& readings);

}  // namespace pendular
