#pragma once

#include "sim/lab/lab_plan.h"

namespace pendular {

/// Checks that a plan can be simulated and recorded. Planned values of liquid content, inertial
/// number, and normal stress of dry or of wet grains must differ by at least 5 %.
/// @throws InputError that names the mistake
void check_plan(const LabPlan& plan);

}  // namespace pendular
