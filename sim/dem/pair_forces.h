#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Computations, besides contact forces, that the loop over the pairs must carry out for a sample.
/// It skips those whose member is false.
struct PairNeeds {
    bool sizes = false;       ///< the grains differ in size
    bool bridges = false;     ///< bridges join grains
    bool accounting = false;  ///< stored and lost energies are summed
    bool effects = false;     ///< effects change or add forces

    static PairNeeds of(const Grains& grains, const PairLaws& laws);
};

/// Adds the forces and torques of a range of pairs to the net force and torque on each grain, and
/// advances the tangential forces and the bridges of these pairs by one time step. Returns the sums
/// over these pairs.
///
/// The loop is compiled for each combination of needs and for each instruction set, on which the
/// result does not depend. Only with effects does it run in two stages, of which the results lie in
/// memory; grains of several sizes without these stages are 2.5 times as fast as with them. Inverse
/// square roots by Newton's iteration, and a loop split in four so that divisions overlap, gave no
/// gain.
///
/// The energies include neither
/// the work of forces and torques that an effect adds nor the energy of bridges whose force an
/// effect changes.
/// @param needs computations to carry out; one that the sample does not need leaves the forces
///         unchanged
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     const PairNeeds& needs, std::vector<Grains::ForceAndTorque>& net_force);

/// Adds the forces of a range of pairs with only the computations that the sample needs.
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     std::vector<Grains::ForceAndTorque>& net_force);

/// Sets the net force and torque on each grain to the sums over the pairs `near`, the narrow
/// neighbour list, which contains all contacts. Returns the sums over these pairs.
PairSums pair_forces(Grains& grains, Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
