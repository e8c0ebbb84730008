#pragma once

#include <cstddef>
#include <random>
#include <span>

#include "data/effect_parameter.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/contact_law.h"

namespace pendular::dem {

/// Batch of pairs of grains that the solver passes to a physical effect, in reduced units (grain
/// diameter, grain mass and imposed normal stress are 1). Each pointer points to an array of `size`
/// elements, one element per pair.
struct PairBatch {
    std::size_t size = 0;
    double time_step = 0;
    /// Components [1] of the unit vector from the first to the second centre of each pair.
    const double *nx, *ny, *nz;
    /// Gap between the surfaces of each pair [grain diameters]. An overlap is a negative gap.
    const double* gap;
    /// Harmonic mean 2 d1 d2/(d1 + d2) of the diameters d1 and d2 of the two grains of each pair,
    /// divided by the mean grain diameter [1].
    const double* diameter;
    const double* normal_speed;  ///< rate at which the gap of each pair grows, in reduced units
    /// Components of the angular velocity of the second grain of each pair minus the angular
    /// velocity of the first grain, in reduced units.
    const double *rolling_x, *rolling_y, *rolling_z;
    /// Components of the angular velocity with which each pair of grains rotates as a whole, in
    /// reduced units.
    const double *pair_rotation_x, *pair_rotation_y, *pair_rotation_z;
    const double* elastic;    ///< elastic normal force of each pair's contact, in reduced units
    const double* stiffness;  ///< tangential stiffness of each pair's contact, in reduced units
    /// State of the liquid bridge of each pair of grains: 1 if a bridge joins the grains, else 0.
    /// The function `bridge` of an effect may change 1 to 0, which breaks the bridge.
    double* joined;
    /// Attraction of each pair by its liquid bridge, in reduced units; 0 without bridge. An effect
    /// may change the attraction, which initially has the value without the effect.
    double* capillary;
    /// Largest tangential force of each pair's contact, in reduced units. An effect may change this
    /// force, which initially is the friction coefficient times `elastic`.
    double* coulomb_limit;
    /// Components of the total force on the second grain of each pair, in reduced units. The
    /// opposite force acts on the first grain. The function `add` of an effect may change the
    /// force, which initially has the value without the effect.
    double *fx, *fy, *fz;
    /// Components of the torque that effects exert on the second grain of each pair, in reduced
    /// units. The opposite torque acts on the first grain. The torque of the tangential contact
    /// force is not included.
    double *tx, *ty, *tz;
    /// Values that the effect stores for each pair from one time step to the next, such as a
    /// tangential displacement. The element contact_history[v][k] is value v of pair k.
    double* const* contact_history = nullptr;
};

/// Material of the grains, bridge law and parameter values of a physical effect, which are equal
/// for all pairs of grains in a run. The functions of the effect receive these data with each batch
/// of pairs (`PairBatch`).
struct PairContext {
    const Material& material;
    const BridgeLaw& bridges;
    /// Parameter values of the effect, in reduced units (grain diameter, grain mass and imposed
    /// normal stress are 1).
    const Values& values;
};

/// Physical effect on the forces between grains. In each time step, the solver calls the functions
/// `bridge`, `limit` and `add` of the effect once for each batch of pairs (`PairBatch`), in this
/// order. A null function changes nothing.
struct ChangePairs {
    using Stage = void (*)(const PairBatch&, const PairContext&);

    /// Number of values that the effect stores for each pair of grains
    /// (`PairBatch::contact_history`), such as a tangential displacement. The values are kept while
    /// the pair is in the neighbour lists. If the first and the second grain of the pair exchange
    /// places, the values change sign, like the components of the force on the second grain.
    std::size_t contact_history = 0;
    /// Whether the first value that the effect stores for a pair (`contact_history`) is the volume
    /// of the pair's bridge, divided by the mean volume V0 of newly formed bridges. The sign of the
    /// value is ignored. If this member is true for an effect of a run, the liquid content follows
    /// from the sum of the bridge volumes. Otherwise each bridge has the volume V0.
    bool volume_in_history = false;
    /// Function that returns the rate [1 per unit of shear strain] at which the volumes of the
    /// bridges on a grain become equal by flow of liquid (`LiquidExchange`). If the function is
    /// null, bridges exchange no liquid.
    double (*exchange_rate)(const Values&) = nullptr;
    /// Whether the effect lets bridges form between grains that do not touch, at any gap below the
    /// rupture distance.
    bool bridges_without_contact = false;
    /// Function that receives the law of the liquid bridges without the effect and returns the law
    /// with the effect. The function is called before a run. If the function is null, the effect
    /// does not change the law.
    BridgeLaw (*bridge_law)(BridgeLaw, const Values&) = nullptr;
    /// Function that changes `PairBatch::capillary`, the attraction of pairs with a bridge. The
    /// function may also break bridges (`PairBatch::joined`).
    Stage bridge = nullptr;
    /// Function that changes `PairBatch::coulomb_limit`, the largest tangential force of contacts.
    Stage limit = nullptr;
    /// Function that adds the forces and torques of the effect between grains. The added forces
    /// count as contact forces, not as capillary forces.
    Stage add = nullptr;
    /// Function that returns the largest damping coefficient (force divided by relative velocity)
    /// of the forces that `add` adds, divided by the mass of a grain, in reduced units (grain
    /// diameter, grain mass and imposed normal stress are 1). The coefficient limits the time step.
    /// If the function is null, the coefficient is 0.
    double (*damping_rate)(const BridgeLaw&, const Values&) = nullptr;
};

/// Physical effect on the sizes of the grains. Before a run, the function `diameters` sets the
/// diameters of all grains from random numbers and the effect's parameter values. The solver then
/// rescales the mean diameter to 1.
struct ChangeSample {
    void (*diameters)(std::span<double>, std::mt19937_64&, const Values&) = nullptr;
};

}  // namespace pendular::dem
