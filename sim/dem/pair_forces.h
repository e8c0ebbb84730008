#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Parts of the force loop, in addition to contacts, that a sample needs. The loop skips a part
/// whose member is false.
struct PairNeeds {
    bool sizes = false;       ///< true if the grains of the sample differ in size
    bool bridges = false;     ///< true if liquid bridges join grains of the sample
    bool accounting = false;  ///< true if the force loop sums stored and lost energies
    bool effects = false;     ///< true if effects change or add forces between the grains

    static PairNeeds of(const Grains& grains, const PairLaws& laws);
};

/// Adds the forces and torques of a range of pairs to the net force and torque on each grain, and
/// advances the tangential forces of their contacts by one time step. In wet samples, contacts form
/// bridges, and grains that a bridge joins attract each other. Returns virial, largest overlap and
/// energies of these pairs.
///
/// Pairs are processed in batches through vector lanes. The instruction set is chosen when the
/// program runs, and does not change the result. Neither does a part of the loop that `needs`
/// requests unnecessarily. The energies include neither the work of forces and torques that an
/// effect adds nor the energy of bridges whose force an effect changes.
/// @param stretch range of `pairs`, in whole batches
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     const PairNeeds& needs, std::vector<Grains::ForceAndTorque>& net_force);

/// Adds the forces and torques of a range of pairs to the net force and torque on each grain, with
/// only the parts of the force loop that the sample needs. Returns virial, largest overlap and
/// energies of these pairs.
/// @param stretch range of `pairs`, in whole batches
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     std::vector<Grains::ForceAndTorque>& net_force);

/// Sets the net forces and torques on all grains to the sums over the pairs of the narrow neighbour
/// list, and returns virial, largest overlap and energies of these pairs.
/// @param near pairs of the narrow neighbour list
PairSums pair_forces(Grains& grains, Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
