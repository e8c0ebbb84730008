#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Adds the attraction by liquid bridges between grains that do not touch to the net force on each
/// grain, and breaks bridges whose gap exceeds the rupture distance. Returns the sums of virials
/// and energies over the pairs. In samples with grains of unequal size, or with effects that change
/// forces, the function calls `pair_forces`.
/// @param stretch range of pairs of the distant neighbour list, in whole batches
PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force);

}  // namespace pendular::dem
