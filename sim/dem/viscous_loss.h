#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Energy that the viscous forces of one step take out of the near pairs, once the loads of all
/// grains are known [a^3 s22]: force times the mean of the normal speeds before and after the step.
/// Near critical damping a step changes that speed by half, so that the speed before it alone would
/// overstate the loss.
double viscous_loss(const Grains& grains, const std::vector<Grains::ForceAndTorque>& net_forces,
                    const Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
