#pragma once

#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"

namespace pendular {

/// Tests torque and gap for a sudden change between two recordings: from one recording on, in the
/// order of time, all readings at repeated conditions differ from earlier readings by a common
/// factor or offset. Returns one entry for torque and one for gap, each at the most significant
/// recording of its column, with the p value. There is no entry if the readings are too few for a
/// test.
///
/// The compared values are the logarithms of stress ratios (torque at the set normal stress) and of
/// gaps, minus their mean at the condition. The values are averaged over each recording, since all
/// readings of a filling have an error in common. For each recording k, a regression on the
/// indicator "from k on" gives Student's t. The p value is multiplied by the number of recordings k
/// that were tested. A column in which a steady trend through the recordings fits better has no
/// sudden change. If repeated conditions leave less than three degrees of freedom, the means of
/// recordings with equal liquid content and volume of grains are compared with a smooth function of
/// normal stress s22 and inertial number I, a + b ln s22 + c (ln s22)^2 + d ln I.
/// @param readings readings from recordings, without readings of tables
std::vector<RecordingFinding> level_change_tests(const std::vector<Reading>& readings,
                                                 const AnnularCell& cell);

}  // namespace pendular
