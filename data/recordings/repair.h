#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Corrects torques that lost their decimal or thousands mark: those that are, within 5 %, a power
/// of ten other than 1 times the torque of the row's shear stress, which replaces them. A doubt
/// lists the rows. Nothing changes if the recording has no shear stresses, or if no torque agrees
/// with its shear stress.
void repair_torques(Recording& recording, const AnnularCell& cell, Measurements& result);

}  // namespace pendular
