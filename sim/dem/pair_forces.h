#pragma once

#include "sim/dem/beads.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Velocity gradient imposed on the sample, reduced units.
struct Flow {
    double shear_rate = 0;   ///< dv1/dx2, equal to the inertial number
    double height_rate = 0;  ///< (dH/dt)/H
};

/// Sums over the pairs of one force evaluation, reduced units.
struct PairSums {
    double virial_11 = 0;  ///< sum of F1 r1, compression positive
    double virial_22 = 0;
    double virial_33 = 0;
    double virial_12 = 0;  ///< sum of F1 r2, negative in simple shear
    double largest_overlap = 0;
};

/// Sets forces and torques of all beads from near pairs and advances the tangential forces by one
/// step `dt`. The tangential force turns with the pair and about its normal, is rescaled when the
/// contact unloads, and obeys the Coulomb limit (contact_law.h) on the elastic force alone. Where
/// `bridges` are wet, contacts form bridges, and what bridges join is attracted (bridge_law.h).
///
/// Pairs are worked on in batches through vector lanes; the instruction set is chosen at run time
/// and does not change a bit of the result.
PairSums pair_forces(Beads& beads, Pairs& pairs, const Cell& cell, const Flow& flow,
                     const Material& material, double dt, const BridgeLaw& bridges = {});

/// Adds the attraction of distant pairs, which bridges join without contact, to forces and sums;
/// breaks the bridges whose gap has passed the rupture distance.
void distant_forces(Beads& beads, Pairs& distant, const Cell& cell, const BridgeLaw& bridges,
                    PairSums& sums);

}  // namespace pendular::dem
