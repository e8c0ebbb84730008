#pragma once

#include <utility>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/flow.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Energies stored in the pairs of grains of a sample, and lost in them during one step [a^3 s22].
struct PairEnergy {
    /// Energy stored in contacts: (2/15) E~ h^(5/2) in normal direction plus s^2/(2 K_T) in
    /// tangential direction; E~: modulus, h: overlap, s: tangential force, K_T: tangential
    /// stiffness.
    double elastic = 0;
    double capillary = 0;  ///< stored: potential energy of the bridges, zero at rupture
    double friction = 0;   ///< energy lost by contacts that slide at the Coulomb limit
    double viscosity = 0;  ///< lost by contacts' viscous normal forces; set from `viscous_loss`
    double bridges = 0;    ///< lost where bridges form: their potential energy jumps below zero
    /// Energy lost by the tangential springs of contacts without sliding: their stiffness changes
    /// with the overlap while they are loaded, and the component of the tangential force along the
    /// new normal is removed.
    double unloading = 0;

    PairEnergy& operator+=(const PairEnergy& other);
};

/// Sums over the pairs of grains in one force evaluation, reduced units: F is the force on the
/// second grain of a pair, r the vector from the first to the second centre.
struct PairSums {
    double virial_11 = 0;  ///< sum of F1 r1 over the pairs, positive in compression
    double virial_22 = 0;
    double virial_33 = 0;
    double virial_12 = 0;  ///< sum of F1 r2 over the pairs, negative in simple shear
    double largest_overlap = 0;
    PairEnergy energy;  ///< zero without energy accounting

    PairSums& operator+=(const PairSums& other);
};

/// Whether a force evaluation also adds up stored and lost energies (PairEnergy), which nearly
/// doubles the time of a step.
enum class EnergyAccounting { off, on };

class GrainEffects;

/// Cell, imposed flow, material, bridge law, time step and effects of one force evaluation.
struct PairLaws {
    Cell cell;
    Flow flow;
    Material material;
    BridgeLaw bridges;
    double time_step = 0;
    EnergyAccounting accounting = EnergyAccounting::off;
    const GrainEffects* effects = nullptr;  ///< effects on the forces between grains; null: none
};

/// Range of pairs in a neighbour list, in whole batches: index of the first pair, and of the pair
/// after the last.
using Stretch = std::pair<std::size_t, std::size_t>;

}  // namespace pendular::dem
