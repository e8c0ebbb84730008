#pragma once

#include "data/annular_cell.h"
#include "data/reading.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Corrects torques that lost their decimal or thousands mark in a recording. The expected torque
/// of a row follows from the row's shear stress. If the ratio of recorded to expected torque is a
/// power of ten other than 1, within 5 %, the function replaces the torque by the expected torque.
/// A message in `result.doubts` lists the corrected rows. Nothing is changed if the recording has
/// no shear stresses, or if no row has a torque that agrees with its shear stress.
void repair_torques(Recording& recording, const AnnularCell& cell, Measurements& result);

}  // namespace pendular
