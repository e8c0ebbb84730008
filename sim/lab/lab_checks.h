#pragma once

#include "sim/lab/lab_plan.h"

namespace pendular {

/// Checks that a plan can be simulated and recorded. Any two planned values of a quantity must
/// differ by at least 5 %. The quantities are the normal stress of dry grains, the normal stress of
/// wet grains, the liquid content and the inertial number.
/// @throws InputError if the plan fails a check; the message names the mistake
void check_plan(const LabPlan& plan);

}  // namespace pendular
