#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Returns the energy that the viscous normal forces of all contacts dissipate in one time step, in
/// units of a^3 s22 (a: grain diameter, s22: imposed normal stress): viscous force times time step
/// times the mean of the normal speeds before and after the step. Taken at mid-step, the loss has
/// no error of first order in the time step, so that the balance of energies closes.
/// @param net_forces net force on each grain, from which the normal speed after the step follows
/// @param near pairs of the narrow neighbour list, which contains all contacts
double viscous_loss(const Grains& grains, const std::vector<Grains::ForceAndTorque>& net_forces,
                    const Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
