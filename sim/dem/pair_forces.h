#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Parts of the force loop that a sample needs in addition to contacts. The loop skips a part whose
/// member is false.
struct PairNeeds {
    bool sizes = false;       ///< grains differ in size
    bool bridges = false;     ///< liquid bridges join grains
    bool accounting = false;  ///< energies are added up
    bool effects = false;     ///< effects change or add forces between grains

    static PairNeeds of(const Grains& grains, const PairLaws& laws);
};

/// Adds the forces and torques of the pairs in the range `stretch` to `net_force` and advances the
/// tangential forces of their contacts by one step. If the grains are wet, contacts form bridges,
/// and grains that a bridge joins attract each other; see pair_contact.h for the laws. Returns
/// virial, largest overlap and energies of these pairs.
///
/// Pairs are processed in batches through vector lanes. The instruction set is chosen at run time
/// and does not change a bit of the result. A need that is set without being necessary does not
/// change the result either. The energies exclude forces and torques that an effect adds, and
/// bridges whose force an effect changes.
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     const PairNeeds& needs, std::vector<Grains::ForceAndTorque>& net_force);

/// Adds the forces and torques of the pairs in the range `stretch` to `net_force`, computing only
/// the parts that the sample needs (`PairNeeds::of`); returns virial, largest overlap and energies
/// of these pairs.
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     std::vector<Grains::ForceAndTorque>& net_force);

/// Sets the net forces and torques on all grains to the sums over the pairs `near` alone (narrow
/// list), and returns virial, largest overlap and energies of these pairs.
PairSums pair_forces(Grains& grains, Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
