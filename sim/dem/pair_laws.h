#pragma once

#include <utility>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Energies of all pairs of grains in a sample, in the reduced unit a^3 s22 (a: grain diameter,
/// s22: imposed normal stress): `elastic` and `capillary` are stored, the others lost during one
/// time step. Over a strain of 1 at I = 0.02 and stiffness number 1000, work of shear and energies
/// balance to 0.2 % of the work, the error of the finite time step (tests/physics/energy.cpp).
struct PairEnergy {
    /// Stored in contacts: (2/15) E~ h^(5/2) in normal and s^2/(2 K_T) in tangential direction,
    /// with overlap h, tangential force s, tangential stiffness K_T and the modulus E~ of
    /// `Material`.
    double elastic = 0;
    double capillary = 0;  ///< stored in bridges; zero where a bridge breaks
    double friction = 0;   ///< sliding at the Coulomb limit
    double viscosity = 0;  ///< viscous normal forces of contacts (`viscous_loss`)
    /// Loss where bridges form, since the potential energy of a bridge then falls abruptly below
    /// zero.
    double bridges = 0;
    /// Loss of the tangential springs other than by sliding: the stiffness of a loaded spring
    /// changes with the overlap, and the component of the force along the new normal is removed.
    double unloading = 0;

    PairEnergy& operator+=(const PairEnergy& other);
};

/// Sums over pairs of grains in one computation of the forces, in reduced units (grain diameter,
/// grain mass and imposed normal stress are 1). In a virial, F is the force on the second grain of
/// a pair, and r the vector from the first to the second centre; divided by the volume, it is the
/// contribution of the forces to the stress. Direction 1 is the flow, 2 the velocity gradient, 3
/// the vorticity.
struct PairSums {
    double virial_11 = 0;  ///< sum of F1 r1, positive in compression
    double virial_22 = 0;
    double virial_33 = 0;
    double virial_12 = 0;  ///< sum of F1 r2, negative in simple shear
    double largest_overlap = 0;
    PairEnergy energy;  ///< zero without energy accounting

    PairSums& operator+=(const PairSums& other);
};

/// Whether energies are summed with the forces, which nearly doubles the time of a time step.
enum class EnergyAccounting { off, on };

class GrainEffects;

/// Laws by which the forces between grains are computed, in reduced units.
struct PairLaws {
    Cell cell;
    Flow flow;
    Material material;
    BridgeLaw bridges;
    double time_step = 0;
    EnergyAccounting accounting = EnergyAccounting::off;
    const GrainEffects* effects = nullptr;  ///< null if there are none
};

/// Range of pairs in a neighbour list, in whole batches of `PairList::batch`: index of the first
/// pair, and index after the last.
using Stretch = std::pair<std::size_t, std::size_t>;

}  // namespace pendular::dem
