#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Computations, in addition to contact forces, that the loop over the pairs of grains must carry
/// out for a sample. The loop skips each computation whose member is false.
struct PairNeeds {
    bool sizes = false;       ///< whether the grains of the sample differ in size
    bool bridges = false;     ///< whether liquid bridges join grains of the sample
    bool accounting = false;  ///< whether stored and lost energies are summed
    bool effects = false;     ///< whether physical effects change or add forces between grains

    static PairNeeds of(const Grains& grains, const PairLaws& laws);
};

/// Adds the forces and torques of a range of pairs to the net force and torque on each grain.
/// Advances the tangential forces and the bridges of the pairs by one time step. Returns the sums
/// of virials and energies, and the largest overlap, of the pairs in the range.
///
/// The result does not depend on the instruction set of the processor. The energies include neither
/// the work of forces and torques that an effect adds nor the energy of bridges whose force an
/// effect changes.
/// @param stretch range of indices in `pairs`, in whole batches (`PairList::batch` pairs each)
/// @param needs computations to carry out; a computation that the sample does not need leaves the
///         forces unchanged
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     const PairNeeds& needs, std::vector<Grains::ForceAndTorque>& net_force);

/// Adds the forces and torques of a range of pairs to the net force and torque on each grain, with
/// only the computations (`PairNeeds`) that the sample needs. Returns the sums of virials and
/// energies, and the largest overlap, of the pairs in the range.
/// @param stretch range of indices in `pairs`, in whole batches (`PairList::batch` pairs each)
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     std::vector<Grains::ForceAndTorque>& net_force);

/// Sets the net force and torque on each grain to the sums over the pairs `near`. Returns the sums
/// of virials and energies, and the largest overlap, of the pairs `near`.
/// @param near pairs of the narrow neighbour list, which contains all contacts
PairSums pair_forces(Grains& grains, Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
