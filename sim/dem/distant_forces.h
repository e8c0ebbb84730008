#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Adds the attraction by liquid bridges between grains that do not touch to the net force on each
/// grain. Breaks bridges whose gap exceeds the rupture distance. Returns the sums of virials and
/// energies over the pairs.
/// @param stretch range of pairs of the distant neighbour list, in whole batches
PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force);

}  // namespace pendular::dem
