#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Energy that the viscous normal forces of all contacts dissipate in one time step [a^3 s22]:
/// viscous force times time step times the mean of the normal speeds before and after the step,
/// which follow from `net_forces`. `near` holds all contacts. Near critical damping a step changes
/// the normal speed by half, so that the speed before it alone would overstate the loss.
double viscous_loss(const Grains& grains, const std::vector<Grains::ForceAndTorque>& net_forces,
                    const Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
