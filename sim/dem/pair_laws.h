#pragma once

#include <utility>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/flow.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Energy stored in pairs, and energy lost in them during one step [a^3 s22].
struct PairEnergy {
    double elastic = 0;    ///< stored: normal (2/15) E~ h^(5/2) plus tangential s^2/(2 K_T)
    double capillary = 0;  ///< stored: potential energy of the bridges, zero at rupture
    double friction = 0;   ///< lost by sliding
    double viscosity = 0;  ///< lost by the viscous part of the normal force; see `viscous_loss`
    double bridges = 0;    ///< lost where bridges form: their potential jumps below zero
    /// Lost by tangential springs without sliding: K_T changes with the overlap while the spring is
    /// loaded, and the component of the force along the new normal is removed.
    double unloading = 0;

    PairEnergy& operator+=(const PairEnergy& other);
};

/// Sums over the pairs of one force evaluation, reduced units.
struct PairSums {
    double virial_11 = 0;  ///< sum of F1 r1, compression positive
    double virial_22 = 0;
    double virial_33 = 0;
    double virial_12 = 0;  ///< sum of F1 r2, negative in simple shear
    double largest_overlap = 0;
    PairEnergy energy;  ///< zero without energy accounting

    PairSums& operator+=(const PairSums& other);
};

/// Whether a force evaluation adds up energies, which nearly doubles the time of a step.
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

/// Range of pairs of a list, in whole batches: index of the first pair, and of the pair after the
/// last.
using Stretch = std::pair<std::size_t, std::size_t>;

}  // namespace pendular::dem
