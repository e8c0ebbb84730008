#pragma once

#include <vector>

#include "sim/dem/change_pairs.h"
#include "sim/dem/pair_lanes.h"

// Data of the force loop in runs with effects on grains. The loop is then split into two stages,
// and effects change the forces between the stages.
namespace pendular::dem {

/// Kinematics and forces of a batch of pairs, in reduced units (grain diameter, grain mass and
/// imposed normal stress are 1). The solver first computes the normal forces, then the tangential
/// forces; after each of the two stages, effects read and change the forces.
struct alignas(64) Stages {
    XyzLanes normal, sliding_velocity;
    XyzLanes rotation_rate;  ///< of the pair as a whole
    XyzLanes rolling;        ///< difference of the angular velocities, second minus first
    XyzLanes own_torque;     ///< of effects on the second grain; the opposite on the first
    Lane gap;                ///< between the surfaces; negative for an overlap
    Lane distance, normal_speed, root, elastic, viscous, joined, capillary, stiffness,
        coulomb_limit;

    [[gnu::always_inline]] ContactKinematics kinematics(std::size_t k) const {
        return {distance[k], normal[k], normal_speed[k], sliding_velocity[k], rotation_rate[k]};
    }
    [[gnu::always_inline]] NormalForces forces(std::size_t k) const {
        return {.overlap = gap[k] < 0 ? -gap[k] : 0.0,
                .gap = gap[k] > 0 ? gap[k] : 0.0,
                .root = root[k],
                .elastic = elastic[k],
                .viscous = viscous[k],
                .joined = joined[k],
                .capillary = capillary[k],
                .stiffness = stiffness[k],
                .coulomb_limit = coulomb_limit[k]};
    }
    [[gnu::always_inline]] void set(std::size_t k, const ContactKinematics& c,
                                    const NormalForces& f) {
        distance[k] = c.distance, normal_speed[k] = c.normal_speed;
        normal.set(k, c.normal);
        sliding_velocity.set(k, c.sliding_velocity);
        rotation_rate.set(k, c.rotation_rate);
        own_torque.set(k, {0, 0, 0});
        gap[k] = f.gap - f.overlap, root[k] = f.root, elastic[k] = f.elastic,
        viscous[k] = f.viscous;
        joined[k] = f.joined, capillary[k] = f.capillary;
        stiffness[k] = f.stiffness, coulomb_limit[k] = f.coulomb_limit;
    }
};

/// Reads the differences of the angular velocities, second minus first, of the pairs in a batch.
[[gnu::always_inline]] inline void gather_rolling(const Grains::Motion* motion, const Pairs& pairs,
                                                  std::size_t begin, XyzLanes& rolling) {
    const std::int32_t* first = pairs.first.data() + begin;
    const std::int32_t* second = pairs.second.data() + begin;
    for (std::size_t k = 0; k < lanes; k += 4) {
        Vector::Lanes w[4];
        for (std::size_t l = 0; l < 4; ++l) {
            w[l] = motion[second[k + l]].angular_velocity.lanes -
                   motion[first[k + l]].angular_velocity.lanes;
        }
        to_lanes(w, k, rolling);
    }
}

/// Returns a `PairBatch` that refers to the data of a batch, without copies.
/// @param contact_history for each value that effects keep, a pointer to the values of the batch
inline PairBatch batch_for_effects(Batch& b, Stages& s, const SizeLanes& sizes, double time_step,
                                   double* const* contact_history) {
    return {.size = lanes,
            .time_step = time_step,
            .nx = s.normal.x.data(),
            .ny = s.normal.y.data(),
            .nz = s.normal.z.data(),
            .gap = s.gap.data(),
            .diameter = sizes.diameter.data(),
            .normal_speed = s.normal_speed.data(),
            .rolling_x = s.rolling.x.data(),
            .rolling_y = s.rolling.y.data(),
            .rolling_z = s.rolling.z.data(),
            .pair_rotation_x = s.rotation_rate.x.data(),
            .pair_rotation_y = s.rotation_rate.y.data(),
            .pair_rotation_z = s.rotation_rate.z.data(),
            .elastic = s.elastic.data(),
            .stiffness = s.stiffness.data(),
            .joined = s.joined.data(),
            .capillary = s.capillary.data(),
            .coulomb_limit = s.coulomb_limit.data(),
            .fx = b.force.x.data(),
            .fy = b.force.y.data(),
            .fz = b.force.z.data(),
            .tx = s.own_torque.x.data(),
            .ty = s.own_torque.y.data(),
            .tz = s.own_torque.z.data(),
            .contact_history = contact_history};
}

}  // namespace pendular::dem
