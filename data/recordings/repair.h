#pragma once

#include "data/annular_cell.h"
#include "data/recordings/recording.h"

namespace pendular {

/// Finds torques that lost their decimal or thousands mark: those that are, within 5 %, a power of
/// ten other than 1 times the torque of the row's shear stress. Empty if the recording has no shear
/// stresses, or if no torque agrees with its shear stress.
/// @param rows receives the marks of the rows with these torques
std::vector<Remark> torques_without_mark(const Recording& recording, const AnnularCell& cell,
                                         std::vector<bool>& rows);

/// Replaces the torques of the marked rows by those of their shear stresses.
void repair_torques(Recording& recording, const AnnularCell& cell, const std::vector<bool>& rows);

}  // namespace pendular
