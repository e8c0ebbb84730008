#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Whether two readings (measured states) were taken at one condition. The liquid contents must be
/// equal, and the readings must be either both steady shear or both points of failure. The normal
/// stresses, inertial numbers, preshear stresses and volumes of grains must agree within 2 %.
bool are_replicates(const Reading& a, const Reading& b);

/// Groups readings (measured states) by condition. Returns the indices of the readings at each
/// condition in ascending order. The conditions are in the order of their first readings. A reading
/// joins the first group whose first reading was taken at the condition of the reading
/// (`are_replicates`). If no group fits, the reading begins a new group.
std::vector<std::vector<std::size_t>> replicate_groups(const std::vector<Reading>& readings);

}  // namespace pendular
