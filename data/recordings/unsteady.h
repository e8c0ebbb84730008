#pragma once

#include "data/annular_cell.h"
#include "data/recordings/step_series.h"

namespace pendular {

/// Returns the shear strain [1] of a step: magnitude of the mean shear rate times the duration.
double strain_of(const StepSeries& series, const AnnularCell& cell);

/// Returns what a step that is too short for steady shear looks like:
/// - unloading or loading: the normal force changes by more than 20 %
/// - consolidation: the gap shrinks by more than 1 %
/// - shear to failure: the torque peaks and drops
/// - shear that was stopped while the torque rose
/// - preshear: the torque levels off
Remark::Kind looks_like(const StepSeries& series);

}  // namespace pendular
