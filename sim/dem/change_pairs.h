#pragma once

#include <cstddef>
#include <random>
#include <span>

#include "data/effect_parameter.h"
#include "sim/dem/bridge_law.h"
#include "sim/dem/contact_law.h"

namespace pendular::dem {

/// One batch of pairs as an effect on grains sees it, structure of arrays of `size` entries,
/// reduced units. Directions point from the first to the second grain.
struct PairBatch {
    std::size_t size = 0;
    double time_step = 0;
    const double *nx, *ny, *nz;  ///< unit normal
    const double* gap;           ///< between the surfaces; negative: overlap
    const double* diameter;      ///< 2 d1 d2/(d1 + d2), which is 1 for grains of unit diameter
    const double* normal_speed;  ///< rate at which the gap opens
    const double *rolling_x, *rolling_y,
        *rolling_z;  ///< angular velocity of the second grain less that of the first
    const double *pair_rotation_x, *pair_rotation_y,
        *pair_rotation_z;     ///< rate at which the pair turns
    const double* elastic;    ///< elastic normal force F_N
    const double* stiffness;  ///< tangential stiffness K_T
    const double* joined;     ///< 1 where a bridge joins the grains, else 0
    double* capillary;        ///< attraction by the bridge, from the base law; 0 where not joined
    double* coulomb_limit;    ///< largest tangential force, from the base law
    double *fx, *fy, *fz;     ///< force on the second grain; on the first it is opposite
    double *tx, *ty, *tz;     ///< torque on the second grain; on the first it is opposite
    double* const* contact_history = nullptr;  ///< contact_history[number][pair]
};

/// Quantities that all pairs of a run share.
struct PairContext {
    const Material& material;
    const BridgeLaw& bridges;
    const Values& values;  ///< of the effect's parameters, reduced units
};

/// An effect on the forces between grains: stages of the force loop, each called once per batch.
struct ChangePairs {
    using Stage = void (*)(const PairBatch&, const PairContext&);

    /// Numbers of contact history per pair, kept when the lists are renewed. They change sign when
    /// the two grains change places, as components of what acts on the second grain do.
    std::size_t contact_history = 0;
    bool bridges_without_contact = false;  ///< bridges form as soon as grains are close enough
    /// Changes the law of the bridges before a run.
    BridgeLaw (*bridge_law)(BridgeLaw, const Values&) = nullptr;
    Stage bridge = nullptr;  ///< replaces `capillary` where a bridge joins the grains
    Stage limit = nullptr;   ///< replaces `coulomb_limit`
    Stage add = nullptr;     ///< adds forces and torques, which count as those of contacts
    /// Largest coefficient of damping that `add` brings in, over the mass of a grain: the time step
    /// follows it.
    double (*damping_rate)(const BridgeLaw&, const Values&) = nullptr;
};

/// An effect on the sizes of the grains, drawn before a run; their mean is kept at 1.
struct ChangeSample {
    void (*diameters)(std::span<double>, std::mt19937_64&, const Values&) = nullptr;
};

}  // namespace pendular::dem
