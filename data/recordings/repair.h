#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Repairs torques of a recording that lost a decimal or thousands mark. The shear stress in each
/// row is converted to a torque. If the recorded torque differs from the converted torque by a
/// power of ten, within 5 %, the recorded torque is replaced. A message that lists the repaired
/// rows is added to `result.doubts`. Nothing is changed if the recording has no shear stresses, or
/// if torque and shear stress agree in no row, since then a unit is wrong.
void repair_torques(Recording& recording, const AnnularCell& cell, Measurements& result);

}  // namespace pendular
