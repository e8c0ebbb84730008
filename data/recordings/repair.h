#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Repairs torques of a recording that lost a decimal or thousands mark. A torque that differs from
/// the torque of its row's shear stress by a power of ten, within 5 %, is replaced by the latter,
/// and a message that lists the rows is added to `result.doubts`. Nothing is changed if the
/// recording has no shear stresses, or if the two columns agree in no row, since then a unit is
/// wrong.
void repair_torques(Recording& recording, const AnnularCell& cell, Measurements& result);

}  // namespace pendular
