#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Adds the attraction of equal grains that a bridge joins without contact to the net force on each
/// grain, and breaks bridges whose gap exceeds the rupture distance. Returns virial and energies of
/// these pairs. Unequal grains, and forces that effects change, need `pair_forces`.
/// @param stretch range of pairs of the distant neighbour list, in whole batches
PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force);

}  // namespace pendular::dem
