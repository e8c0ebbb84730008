#pragma once

#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"

namespace pendular {

/// Tests torque and gap for a sudden change between two recordings, from which on readings differ
/// by a common factor or offset from earlier ones at the same condition. Returns one entry for
/// torque and one for gap with the p value of the most significant change, 1 if a steady trend
/// through the recordings fits better; none if the readings are too few.
///
/// If too few conditions are repeated, a fitted function of normal stress s22 and inertial number I
/// takes the place of the mean at each condition:
///     a + b ln s22 + c (ln s22)^2 + d ln I
/// @param readings from recordings, not from tables
std::vector<Remark> level_change_tests(const std::vector<Reading>& readings,
                                       const AnnularCell& cell);

}  // namespace pendular
