#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Replaces torques that lost a decimal or thousands mark by the torque of the row's shear stress:
/// those that differ from it by a power of ten, within 5 %, while other rows agree with it. Adds a
/// doubt that lists the rows to `result`. Does nothing for a recording without shear stresses, and
/// where no row agrees: there the unit of a column is wrong.
void repair_torques(Recording& recording, const AnnularCell& cell, Measurements& result);

}  // namespace pendular
