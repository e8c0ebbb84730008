#pragma once

#include <cstddef>
#include <random>
#include <span>

#include "data/effect_parameter.h"

namespace pendular::dem {

struct BridgeLaw;
struct Material;

/// Batch of pairs of grains that the solver passes to an effect, in reduced units (grain diameter,
/// grain mass and imposed normal stress are 1). Each pointer points to `size` elements, one per
/// pair. Motion is that of the second grain relative to the first. Forces and torques act on the
/// second grain, the opposite ones on the first.
struct PairBatch {
    std::size_t size = 0;
    double time_step = 0;
    const double *nx, *ny, *nz;  ///< unit vector from the first to the second centre
    const double* gap;           ///< between the surfaces; an overlap is a negative gap
    const double* diameter;      ///< harmonic mean 2 d1 d2/(d1 + d2), over the mean diameter
    const double* normal_speed;  ///< rate at which the gap grows
    const double *rolling_x, *rolling_y, *rolling_z;  ///< difference of the angular velocities
    /// Angular velocity with which the pair rotates as a whole.
    const double *pair_rotation_x, *pair_rotation_y, *pair_rotation_z;
    const double* elastic;    ///< elastic normal force
    const double* stiffness;  ///< tangential stiffness
    double* joined;  ///< 1 if a bridge joins the grains, else 0; `bridge` may change 1 to 0
    /// Attraction by the bridge, 0 without one. `bridge` may change it.
    double* capillary;
    /// Largest tangential force of the contact: friction coefficient times `elastic`, before
    /// `limit` changes it.
    double* coulomb_limit;
    double *fx, *fy, *fz;  ///< total force, to which `add` may add
    /// Torque of effects, without that of the tangential contact force.
    double *tx, *ty, *tz;
    /// Values that the effect keeps for each pair from step to step: contact_history[v][k] is value
    /// v of pair k.
    double* const* contact_history = nullptr;
};

/// Data of an effect's functions that are equal for all pairs of a run.
struct PairContext {
    const Material& material;
    const BridgeLaw& bridges;
    const Values& values;  ///< parameters of the effect, in reduced units
};

/// Effect on the forces between grains. In each time step, the solver calls `bridge`, `limit` and
/// `add` once for each batch of pairs, in this order. A null function changes nothing.
struct ChangePairs {
    using Stage = void (*)(const PairBatch&, const PairContext&);

    /// Number of values that the effect keeps for each pair (`PairBatch::contact_history`), such as
    /// a tangential displacement, while the pair is in the neighbour lists. If the first and the
    /// second grain exchange places, the values change sign, like a force on the second grain.
    std::size_t contact_history = 0;
    /// Whether the first value of `contact_history` is the volume of the pair's bridge over the
    /// mean volume V0 of newly formed bridges; its sign is ignored. The liquid content then follows
    /// from the sum of the volumes. Otherwise each bridge has the volume V0.
    bool volume_in_history = false;
    /// Rate [1 per unit of shear strain] at which the volumes of the bridges on a grain become
    /// equal by flow of liquid (`LiquidExchange`).
    double (*exchange_rate)(const Values&) = nullptr;
    /// Whether bridges form between grains that do not touch, at any gap below the rupture
    /// distance.
    bool bridges_without_contact = false;
    BridgeLaw (*bridge_law)(BridgeLaw, const Values&) = nullptr;  ///< changes the law before a run
    Stage bridge = nullptr;  ///< changes `capillary` and may break bridges
    Stage limit = nullptr;   ///< changes `coulomb_limit`
    /// Adds forces and torques of the effect. They count as contact forces, not as capillary
    /// forces.
    Stage add = nullptr;
    /// Largest damping coefficient (force over relative velocity) of the forces of `add`, over the
    /// mass of a grain, in reduced units. It limits the time step.
    double (*damping_rate)(const BridgeLaw&, const Values&) = nullptr;
};

/// Effect on the sizes of the grains: `diameters` sets all diameters before a run, from random
/// numbers and the effect's parameters. The solver then rescales the mean diameter to 1.
struct ChangeSample {
    void (*diameters)(std::span<double>, std::mt19937_64&, const Values&) = nullptr;
};

}  // namespace pendular::dem
