#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// For pairs of equal grains that a bridge joins but that do not touch, adds the attraction by the
/// bridge to the net force on each grain, and breaks bridges whose gap exceeds the rupture
/// distance. Returns virial and energies of the pairs. Grains of unequal size, and forces that
/// effects change, need `pair_forces` instead.
/// @param stretch range of pairs of the distant neighbour list, in whole batches
PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force);

}  // namespace pendular::dem
