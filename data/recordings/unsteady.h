#pragma once

#include <string>

#include "data/annular_cell.h"
#include "data/recordings/step_series.h"

namespace pendular {

/// Strain of a series [1]: mean shear rate times the time from its first to its last sample.
double strain_of(const StepSeries& series, const AnnularCell& cell);

/// Describes a step that is too short for steady shear: loading or unloading (the normal force
/// changes by more than a fifth), consolidation (the gap shrinks by more than 1 %), shear to
/// failure (the torque peaks and drops), preshear (it levels off), or shear that was stopped while
/// it rose.
std::string looks_like(const StepSeries& series);

}  // namespace pendular
