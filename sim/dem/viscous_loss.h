#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Returns the energy that the viscous normal forces of all contacts dissipate in one time step, in
/// units of a^3 s22, with grain diameter a and imposed normal stress s22. The loss of a contact is
/// viscous force times time step times the mean of the normal speeds before and after the step.
/// @param net_forces net force on each grain, from which the normal speed after the step follows
/// @param near pairs of the narrow neighbour list, which contains all contacts
double viscous_loss(const Grains& grains, const std::vector<Grains::ForceAndTorque>& net_forces,
                    const Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
