#pragma once

#include <cstddef>
#include <random>
#include <span>

#include "sim/dem/bridge_law.h"
#include "sim/dem/contact_law.h"
#include "sim/effect_values.h"

namespace pendular::dem {

/// One batch of pairs as an effect on grains sees it, structure of arrays, reduced units; `size`
/// entries each. Directions point from the first to the second bead.
struct PairBatch {
    std::size_t size = 0;
    const double *nx, *ny, *nz;  ///< unit normal
    const double* gap;           ///< between the surfaces; negative: overlap
    const double* diameter;      ///< 4 R1 R2/(R1 + R2), 1 for beads of unit diameter
    const double* normal_speed;  ///< rate at which the gap opens
    const double *rolling_x, *rolling_y, *rolling_z;  ///< spin of the second less that of the first
    const double *turn_x, *turn_y, *turn_z;           ///< rate at which the pair turns
    const double* elastic;                            ///< elastic normal force F_N
    const double* stiffness;                          ///< its derivative K_N
    const double* joined;                             ///< 1 where a bridge joins the beads, else 0
    double* capillary;         ///< attraction of the bridge, filled by the base law
    double* coulomb_limit;     ///< largest tangential force, likewise
    double *fx, *fy, *fz;      ///< force on the second bead; on the first it is opposite
    double *tx, *ty, *tz;      ///< torque on the second bead; on the first it is opposite
    double* memory = nullptr;  ///< word w of pair k is memory[w * size + k]; survives new lists
    double time_step = 0;
};

/// What is the same for all pairs.
struct PairContext {
    const Material& material;
    const BridgeLaw& bridges;
    const Values& values;
};

/// An effect on the forces between grains: stages of the force loop, each called once per batch.
struct ChangePairs {
    using Stage = void (*)(const PairBatch&, const PairContext&);

    std::size_t memory = 0;                ///< words that each pair remembers
    bool bridges_without_contact = false;  ///< bridges form as soon as beads are close enough
    /// Changes the parameters of the bridges before a run.
    BridgeLaw (*bridge_law)(BridgeLaw, const Values&) = nullptr;
    Stage bridge = nullptr;  ///< replaces `capillary` where a bridge joins the beads
    Stage limit = nullptr;   ///< replaces `coulomb_limit`
    Stage add = nullptr;     ///< adds forces and torques, which count as those of contacts
    /// Largest damping coefficient that `add` brings in, over a bead's mass, for the time step.
    double (*damping_rate)(const BridgeLaw&, const Values&) = nullptr;
};

/// An effect on the sizes of the beads, drawn before a run; the mean diameter stays 1.
struct ChangeSample {
    void (*diameters)(std::span<double>, std::mt19937_64&, const Values&) = nullptr;
};

}  // namespace pendular::dem
