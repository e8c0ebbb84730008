#pragma once

#include <utility>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/flow.h"
#include "sim/dem/grains.h"
#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Energies of all pairs of grains in a sample, in the reduced unit a^3 s22, with grain diameter a
/// and imposed normal stress s22. The members `elastic` and `capillary` are stored energies. The
/// other members are energies lost during one time step.
struct PairEnergy {
    /// Elastic energy stored in all contacts, in reduced units. A contact stores (2/15) E~ h^(5/2)
    /// in normal direction and s^2/(2 K_T) in tangential direction, with overlap h, tangential
    /// force s and tangential stiffness K_T. E~ is E/(1 - nu^2), with Young's modulus E and Poisson
    /// ratio nu.
    double elastic = 0;
    /// Potential energy stored in all liquid bridges, in reduced units. The energy of a bridge is
    /// zero at the gap at which the bridge breaks.
    double capillary = 0;
    /// Energy lost in one time step by contacts that slide at the Coulomb limit, in reduced units.
    double friction = 0;
    /// Energy lost in one time step by the viscous normal forces of contacts, in reduced units. The
    /// function `viscous_loss` computes this energy.
    double viscosity = 0;
    /// Energy lost in one time step when liquid bridges form, in reduced units. The energy is lost
    /// because the potential energy of a bridge falls abruptly below zero when the bridge forms.
    double bridges = 0;
    /// Energy lost in one time step by the tangential springs of contacts in other ways than by
    /// sliding, in reduced units. The energy is lost because the stiffness of a loaded spring
    /// changes with the overlap, and because the component of the tangential force along the new
    /// normal is removed.
    double unloading = 0;

    PairEnergy& operator+=(const PairEnergy& other);
};

/// Sums over the pairs of grains in one computation of the forces, in reduced units (grain
/// diameter, grain mass and imposed normal stress are 1). In a virial, F is the force on the second
/// grain of a pair, and r the vector from the first to the second centre. Direction 1 is the flow,
/// 2 the velocity gradient, 3 the vorticity.
struct PairSums {
    /// Sum of F1 r1 over the pairs of grains, in reduced units, positive in compression. The sum
    /// divided by the volume is the contribution of the forces to the normal stress s11.
    double virial_11 = 0;
    double virial_22 = 0;
    double virial_33 = 0;
    /// Sum of F1 r2 over the pairs of grains, in reduced units, negative in simple shear. The sum
    /// divided by the volume is the contribution of the forces to the shear stress s12.
    double virial_12 = 0;
    double largest_overlap = 0;
    PairEnergy energy;  ///< stored and lost energies of the pairs, zero without energy accounting

    PairSums& operator+=(const PairSums& other);
};

/// Whether stored and lost energies (`PairEnergy`) are summed while the forces are computed. The
/// summation of energies nearly doubles the computing time of a time step.
enum class EnergyAccounting { off, on };

class GrainEffects;

/// Cell, imposed flow, material, bridge law, time step and effects with which the forces between
/// grains are computed, in reduced units (grain diameter, grain mass and imposed normal stress are
/// 1).
struct PairLaws {
    Cell cell;
    Flow flow;
    Material material;
    BridgeLaw bridges;
    double time_step = 0;
    EnergyAccounting accounting = EnergyAccounting::off;
    /// Physical effects on the forces between grains; null if there are none.
    const GrainEffects* effects = nullptr;
};

/// Range of pairs in a neighbour list: first the index of the first pair, second the index after
/// the last pair. The range consists of whole batches (`PairList::batch` pairs each).
using Stretch = std::pair<std::size_t, std::size_t>;

}  // namespace pendular::dem
