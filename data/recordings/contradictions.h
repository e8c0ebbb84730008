#pragma once

#include <vector>

#include "data/annular_cell.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Finds rows of a recording in which two columns that measure one quantity contradict each other.
/// The pairs are shear stress and torque, normal stress and normal force, and shear rate and
/// angular velocity. Values of a pair, converted with the radii of the cell, may differ by the sum
/// of 5 % and the resolution of both columns. If their median ratio differs from 1 by more than
/// 2 %, one remark is on the whole column (`wrong_factor`), and no row is found for this pair; a
/// median ratio of shear rates between 0.5 and 2 is no doubt, since instruments may state the rate
/// at another radius than the mean, such as the rim.
/// @param rows receives the marks of the rows in which columns contradict each other
std::vector<Remark> contradictions(const Recording& recording, const AnnularCell& cell,
                                   std::vector<bool>& rows);

}  // namespace pendular
