#pragma once

#include <vector>

#include "sim/dem/pair_laws.h"

namespace pendular::dem {

/// Adds the forces and torques of a stretch of near pairs to `load` and advances their tangential
/// forces by one step. The tangential force turns with the pair and about its normal, is rescaled
/// when the contact unloads, and obeys the Coulomb limit (contact_law.h) on the elastic force
/// alone. Where bridges are wet, contacts form them, and what they join is attracted
/// (bridge_law.h).
///
/// Pairs are worked on in batches through vector lanes; the instruction set is chosen at run time
/// and does not change a bit of the result.
PairSums near_forces(const Beads& beads, Pairs& near, Stretch stretch, const PairLaws& laws,
                     std::vector<Beads::Load>& load);

/// Adds the attraction of a stretch of distant pairs, which bridges join without contact; breaks
/// the bridges whose gap has passed the rupture distance.
PairSums distant_forces(const Beads& beads, Pairs& distant, Stretch stretch, const PairLaws& laws,
                        std::vector<Beads::Load>& load);

/// The same as `near_forces` and `distant_forces` for pairs of either kind, with effects on grains
/// and beads of any size. Forces and torques that an effect adds are not in the books of energy,
/// nor are bridges whose force it changes.
PairSums hooked_forces(const Beads& beads, Pairs& pairs, Stretch stretch, const PairLaws& laws,
                       std::vector<Beads::Load>& load);

/// Energy that the viscous forces of one step take out of the near pairs, once the loads of all
/// beads are known [a^3 s22]: force times the mean of the normal speeds before and after the step.
/// Near critical damping a step changes that speed by half, so that the speed before it alone would
/// overstate the loss.
double viscous_loss(const Beads& beads, const std::vector<Beads::Load>& loads, const Pairs& near,
                    const PairLaws& laws);

/// Sets forces and torques of all beads from the near pairs alone.
PairSums pair_forces(Beads& beads, Pairs& near, const PairLaws& laws);

}  // namespace pendular::dem
