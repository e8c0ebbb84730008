#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Corrects torques of a recording that are wrong by a power of ten, since they lost a decimal or
/// thousands mark. The shear stress in each row is converted to a torque. If the recorded torque
/// differs from the converted torque by a power of ten, within 5 %, the converted torque replaces
/// the recorded torque. A message that lists the corrected rows is added to `result.doubts`.
/// Nothing is changed if the recording has no shear stresses. Nothing is changed either if torque
/// and shear stress agree in no row, since a unit is then probably wrong.
void repair_torques(Recording& recording, const AnnularCell& cell, Measurements& result);

}  // namespace pendular
