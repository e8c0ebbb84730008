#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Adds the attraction by liquid bridges, between grains that do not touch, to the net force on
/// each grain. Breaks bridges whose gap exceeds the rupture distance. Returns the sums of virials
/// and energies over the pairs of grains.
/// @param distant pairs of grains that do not touch but may be joined by a bridge
/// @param stretch range of indices in `distant`, in whole batches (`PairList::batch` pairs each)
/// @param net_force net force and torque on each grain
PairSums distant_forces(const Grains& grains, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Grains::ForceAndTorque>& net_force);

}  // namespace pendular::dem
