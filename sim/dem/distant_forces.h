#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Adds to `net_force` the attraction of the distant pairs in the range `stretch`, which liquid
/// bridges join without contact, and breaks bridges whose gap exceeds the rupture distance. Returns
/// virial and energies of these pairs. Unequal grains, and forces that effects change, are left to
/// `pair_forces`.
PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force);

}  // namespace pendular::dem
