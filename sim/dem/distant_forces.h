#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Adds the attraction by bridges between grains that do not touch to the net force on each grain,
/// and breaks bridges whose gap exceeds the rupture distance. Returns the sums over these pairs.
/// @param distant pairs of the distant neighbour list
/// @param stretch indices in `distant`
PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force);

}  // namespace pendular::dem
