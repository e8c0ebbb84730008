#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Parts of the force loop, in addition to contacts, that a sample needs. The loop skips each part
/// whose member is false.
struct PairNeeds {
    bool sizes = false;       ///< whether the grains of the sample differ in size
    bool bridges = false;     ///< whether liquid bridges join grains of the sample
    bool accounting = false;  ///< whether the force loop sums stored and lost energies
    bool effects = false;     ///< whether effects change or add forces between the grains

    static PairNeeds of(const Grains& grains, const PairLaws& laws);
};

/// Adds the forces and torques of a range of pairs to the net force and torque on each grain.
/// Advances the tangential forces and the bridges of the pairs by one time step. Returns the sums
/// of virials and energies, and the largest overlap, of the pairs in the range.
///
/// The result does not depend on the instruction set of the processor. The energies include neither
/// the work of forces and torques that an effect adds nor the energy of bridges whose force an
/// effect changes.
/// @param stretch range of `pairs`, in whole batches
/// @param needs parts of the force loop; a part that the sample does not need leaves the forces
///         unchanged
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     const PairNeeds& needs, std::vector<Grains::ForceAndTorque>& net_force);

/// Adds the forces and torques of a range of pairs to the net force and torque on each grain, with
/// only the parts of the force loop that the sample needs. Returns the sums of virials and
/// energies, and the largest overlap, of the pairs in the range.
/// @param stretch range of `pairs`, in whole batches
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     std::vector<Grains::ForceAndTorque>& net_force);

/// Sets the net force and torque on each grain to the sums over the pairs of the narrow neighbour
/// list. Returns the sums of virials and energies, and the largest overlap, of these pairs.
/// @param near pairs of the narrow neighbour list, which contains all contacts
PairSums pair_forces(Grains& grains, Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
