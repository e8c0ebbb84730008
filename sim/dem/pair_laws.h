#pragma once

#include <utility>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/flow.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Energy that pairs hold and energy that they lost during one step [a^3 s22].
struct PairEnergy {
    double elastic = 0;    ///< normal (2/15) E~ h^(5/2) plus tangential s^2/(2 K_T)
    double capillary = 0;  ///< potential of the bridges, zero at rupture
    double friction = 0;   ///< lost by sliding
    double viscosity = 0;  ///< lost by the viscous part of the normal force; see `viscous_loss`
    double bridges = 0;  ///< lost where a bridge forms: its potential jumps from zero to its depth
    /// Lost by tangential springs without sliding: K_T changes with the overlap under a force that
    /// is there, and what points along the new normal is dropped.
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

/// The laws of one force evaluation.
struct PairLaws {
    Cell cell;
    Flow flow;
    Material material;
    BridgeLaw bridges;
    double time_step = 0;
    EnergyAccounting accounting = EnergyAccounting::off;
    const GrainEffects* effects = nullptr;  ///< on the forces between grains; none: null
};

/// Range of a pair list in whole batches: its first pair and the one after its last.
using Stretch = std::pair<std::size_t, std::size_t>;

}  // namespace pendular::dem
