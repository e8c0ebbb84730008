#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Corrects torques of a recording that lost a decimal or thousands mark. If a torque differs by a
/// power of ten, within 5 %, from the torque that follows from the shear stress of the row, the
/// function replaces the torque. A message in `result.doubts` lists the corrected rows. Nothing is
/// changed if the recording has no shear stresses, or if torque and shear stress agree in no row.
void repair_torques(Recording& recording, const AnnularCell& cell, Measurements& result);

}  // namespace pendular
