#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Whether two readings (measured states) were taken at the same condition: their liquid contents
/// are equal, both are steady shear or both are points of failure, and their normal stresses,
/// inertial numbers, preshear stresses and volumes of grains agree within 2 %.
bool are_replicates(const Reading& a, const Reading& b);

/// Groups readings (measured states) by condition. Returns for each condition the indices of its
/// readings in ascending order; conditions are in the order of their first readings. A reading
/// joins the first group whose first reading it replicates (`are_replicates`), else it begins a new
/// group.
std::vector<std::vector<std::size_t>> replicate_groups(const std::vector<Reading>& readings);

}  // namespace pendular
