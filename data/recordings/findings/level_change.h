#pragma once

#include <vector>

#include "data/annular_cell.h"
#include "data/reading.h"

namespace pendular {

/// Tests of torque and gap for a step between recordings: from one recording on, in the order of
/// time, all readings at repeated conditions differ from earlier ones by a common factor or offset.
/// One entry for each column, with the most significant recording.
///
/// Logarithms of stress ratios (torque at the set normal stress) and gaps, less their mean at the
/// condition, are averaged over each recording, since all readings of a filling share an error. For
/// each recording k, their regression on "from k on" gives Student's t; the p value is multiplied
/// by the number of recordings k that were tested. A steady trend through the recordings that
/// describes them better than the step is no step. Where less than three degrees of freedom are
/// left, the means of recordings with equal liquid content and volume of grains are compared with a
/// smooth function of their conditions, a + b ln s22 + c (ln s22)^2 + d ln I.
/// @param readings readings from recordings, without readings of tables
std::vector<RecordingFinding> level_change_tests(const std::vector<Reading>& readings,
                                                 const AnnularCell& cell);

}  // namespace pendular
