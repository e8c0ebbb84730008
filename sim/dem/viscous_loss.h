#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Energy that the viscous forces of contacts dissipate in one step [a^3 s22], given the near pairs
/// and the net forces on all grains: force times time step times the mean of the normal speeds
/// before and after the step. Near critical damping a step changes the normal speed by half, so
/// that the speed before the step alone would overstate the loss.
double viscous_loss(const Grains& grains, const std::vector<Grains::ForceAndTorque>& net_forces,
                    const Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
