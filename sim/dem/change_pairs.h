#pragma once

#include <cstddef>
#include <random>
#include <span>

#include "data/effect_parameter.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/contact_law.h"

namespace pendular::dem {

/// Batch of pairs of grains as passed to an effect on grains: arrays of `size` entries, one per
/// pair, in reduced units. Vectors point from the first to the second grain.
struct PairBatch {
    std::size_t size = 0;
    double time_step = 0;
    const double *nx, *ny, *nz;  ///< unit vector from the first to the second centre
    const double* gap;           ///< gap between the grains' surfaces; negative: overlap
    const double* diameter;      ///< mean 2 d1 d2/(d1 + d2) of the two grains' diameters
    const double* normal_speed;  ///< rate at which the gap between the surfaces opens
    const double *rolling_x, *rolling_y,
        *rolling_z;  ///< angular velocity of the second grain minus that of the first
    const double *pair_rotation_x, *pair_rotation_y,
        *pair_rotation_z;     ///< angular velocity at which the pair turns as a whole
    const double* elastic;    ///< elastic normal force F_N of the contact
    const double* stiffness;  ///< tangential stiffness K_T of the contact
    const double* joined;     ///< 1 where a liquid bridge joins the grains, else 0
    double* capillary;      ///< attraction by the bridge, preset by the base law; 0 without bridge
    double* coulomb_limit;  ///< largest tangential force, preset to friction times `elastic`
    double *fx, *fy, *fz;   ///< force on the second grain; the first gets the opposite force
    double *tx, *ty, *tz;   ///< torque on the second grain; the first gets the opposite torque
    /// Values that the effect stores from step to step for each pair: contact_history[value][pair].
    double* const* contact_history = nullptr;
};

/// Material, bridge law and effect parameters, which all pairs of a run share.
struct PairContext {
    const Material& material;
    const BridgeLaw& bridges;
    const Values& values;  ///< values of the effect's parameters, reduced units
};

/// Physical effect on the forces between grains. The force loop calls its functions `bridge`,
/// `limit` and `add` once per batch of pairs, in this order; a null function changes nothing.
struct ChangePairs {
    using Stage = void (*)(const PairBatch&, const PairContext&);

    /// Number of values that the effect stores per pair (PairBatch::contact_history). They are kept
    /// when the neighbour lists are renewed, and change sign when the two grains of a pair swap, as
    /// components of the force on the second grain do.
    std::size_t contact_history = 0;
    /// Whether bridges form without contact, at any gap below the rupture distance.
    bool bridges_without_contact = false;
    /// Returns the law of the liquid bridges, given without the effect, as the effect changes it;
    /// called before a run. Null: unchanged.
    BridgeLaw (*bridge_law)(BridgeLaw, const Values&) = nullptr;
    Stage bridge = nullptr;  ///< overwrites PairBatch::capillary where a bridge joins the grains
    Stage limit = nullptr;   ///< overwrites PairBatch::coulomb_limit
    Stage add = nullptr;  ///< adds forces and torques, which count as contact forces, not capillary
    /// Returns the largest damping coefficient (force over relative velocity) of the forces that
    /// `add` adds, over the mass of a grain, reduced units. It limits the time step. Null: 0.
    double (*damping_rate)(const BridgeLaw&, const Values&) = nullptr;
};

/// Physical effect on the sizes of the grains. The function `diameters` draws the grains' diameters
/// before a run; the solver then rescales the mean diameter to 1.
struct ChangeSample {
    void (*diameters)(std::span<double>, std::mt19937_64&, const Values&) = nullptr;
};

}  // namespace pendular::dem
