#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Parts of the force loop that a sample needs beside contacts; what is false is not computed.
struct PairNeeds {
    bool sizes = false;       ///< grains differ in size
    bool bridges = false;     ///< liquid bridges join grains
    bool accounting = false;  ///< energies are added up
    bool effects = false;     ///< effects change or add forces between grains

    static PairNeeds of(const Grains& grains, const PairLaws& laws);
};

/// Adds the forces and torques of a stretch of pairs to `net_force` and advances the tangential
/// forces of their contacts by one step. Where bridges are wet, contacts form them, and the grains
/// that they join attract each other. The laws stand in pair_contact.h.
///
/// Pairs are worked on in batches through vector lanes; the instruction set is chosen at run time
/// and does not change a bit of the result, nor do needs that a sample does not have. Forces and
/// torques that an effect adds are left out of the energies, and so are bridges whose force it
/// changes.
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     const PairNeeds& needs, std::vector<Grains::ForceAndTorque>& net_force);

/// Adds the forces of a stretch of pairs, computing only what this sample needs.
PairSums pair_forces(const Grains& grains, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                     std::vector<Grains::ForceAndTorque>& net_force);

/// Sets forces and torques of all grains from the near pairs alone.
PairSums pair_forces(Grains& grains, Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
