#pragma once

#include <cstddef>
#include <vector>

#include "data/reading.h"

namespace pendular {

/// Whether two readings were taken at one condition: equal liquid contents, both steady shear or
/// both failure, and normal stresses, inertial numbers, preshear stresses and volumes of grains
/// that agree within 2 %.
bool are_replicates(const Reading& a, const Reading& b);

/// Returns the indices of the readings at each condition in ascending order, by the order of the
/// first readings. A reading joins the first group of whose first reading it is a replicate
/// (`are_replicates`), and otherwise begins a group.
std::vector<std::vector<std::size_t>> replicate_groups(const std::vector<Reading>& readings);

}  // namespace pendular
