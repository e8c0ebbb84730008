#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Adds the attraction of a stretch of distant pairs, which bridges join without contact; breaks
/// the bridges whose gap has passed the rupture distance. Pairs of unequal grains, and pairs whose
/// forces effects change, go through `pair_forces`.
PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force);

}  // namespace pendular::dem
