#pragma once

#include <cmath>

#include "sim/dem/bridge_law.h"
#include "sim/dem/cell.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/grains.h"

// Laws of contact and bridge for one pair of grains, in reduced units: grain diameter a, grain mass
// and imposed normal stress s22 are 1, forces are in a^2 s22, energies and torques in a^3 s22. The
// loops over pairs (pair_forces.cpp, viscous_loss.cpp) inline these functions and process many
// pairs at once in vector lanes. Functions here must therefore not branch, nor call a function that
// has no vector instruction.
namespace pendular::dem {

/// Vector of three numbers. In a loop over pairs of grains, the compiler keeps the vectors of
/// several pairs in SIMD lanes.
struct Xyz {
    double x, y, z;

    [[gnu::always_inline]] friend Xyz operator+(const Xyz& a, const Xyz& b) {
        return {a.x + b.x, a.y + b.y, a.z + b.z};
    }
    [[gnu::always_inline]] friend Xyz operator-(const Xyz& a, const Xyz& b) {
        return {a.x - b.x, a.y - b.y, a.z - b.z};
    }
    [[gnu::always_inline]] friend Xyz operator*(double factor, const Xyz& a) {
        return {factor * a.x, factor * a.y, factor * a.z};
    }
};

[[gnu::always_inline]] inline double dot(const Xyz& a, const Xyz& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[gnu::always_inline]] inline Xyz cross(const Xyz& a, const Xyz& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Relative position and velocities of two grains: second minus first.
struct PairMotion {
    Xyz separation;  ///< from the first to the second centre
    Xyz velocity;    ///< without the imposed flow
    /// Sum of the angular velocities. For unequal grains, each is weighted with the distance from
    /// the grain's centre to the contact point, over half the distance between the centres.
    Xyz angular_velocity;
};

/// Distance, direction and relative velocities of two grains, with the imposed flow.
struct ContactKinematics {
    double distance;       ///< of the centres
    Xyz normal;            ///< from the first to the second centre
    double normal_speed;   ///< rate at which the distance grows
    Xyz sliding_velocity;  ///< of the second surface relative to the first, at the contact point
    /// Angular velocity with which the pair rotates as a whole, including the rotation about the
    /// line of centres.
    Xyz rotation_rate;

    [[gnu::always_inline]] static ContactKinematics of(const PairMotion& motion, const Flow& flow) {
        const auto& [r, v, angular_velocity] = motion;
        const double distance = std::sqrt(dot(r, r)), inverse = 1 / distance;
        const Xyz normal = inverse * r;
        const Xyz velocity = {v.x + flow.length_rate * r.x + flow.shear_rate * r.y,
                              v.y + flow.height_rate * r.y, v.z + flow.width_rate * r.z};
        const double normal_speed = dot(velocity, normal);
        const Xyz tangential = velocity - normal_speed * normal;
        const double arm = distance * 0.5;  // unequal arms are in the weights of angular_velocity
        const double twist = 0.5 * dot(angular_velocity, normal);
        return {distance, normal, normal_speed, tangential - arm * cross(angular_velocity, normal),
                inverse * cross(normal, tangential) + twist * normal};
    }
};

/// Returns the Hertz contact of two grains of any sizes. Grains of the diameters d1 and d2 have the
/// stiffness of two equal grains of the diameter 2 d1 d2/(d1 + d2).
[[gnu::always_inline]] inline Hertz hertz_contact(double overlap, const PairSizes& sizes,
                                                  double modulus) {
    return Hertz::at(overlap, modulus * std::sqrt(sizes.diameter));
}

/// Returns the tangential stiffness of a contact, in units of a s22.
/// @param root square root of the overlap
[[gnu::always_inline]] inline double tangential_stiffness(double root, const PairSizes& sizes,
                                                          const Material& material) {
    const double modulus = material.modulus * std::sqrt(sizes.diameter);
    return tangential_ratio(material.poisson_ratio) * (modulus / 2 * root);
}

/// Returns the viscous normal force of a contact, positive while the grains approach each other.
/// @param normal_speed rate at which the distance between the centres grows
/// @param damping fraction of critical damping [1]
[[gnu::always_inline]] inline double viscous_force(const Hertz& hertz, double normal_speed,
                                                   const PairSizes& sizes, double damping) {
    return hertz.viscous(-normal_speed, damping) * std::sqrt(sizes.mass);
}

/// Normal forces of a pair of grains, and the quantities on which its tangential force depends. All
/// forces are zero for a pair with neither contact nor bridge.
struct NormalForces {
    double overlap;        ///< 0 without contact
    double gap;            ///< between the surfaces, 0 in contact
    double root;           ///< square root of `overlap`
    double elastic;        ///< normal force of the contact, a repulsion
    double viscous;        ///< normal force of the contact, positive for repulsion
    double joined = 0;     ///< 1 if a bridge joins the grains, else 0
    double capillary = 0;  ///< attraction by the bridge, 0 without one
    double stiffness;      ///< tangential
    double coulomb_limit;  ///< tangential force at which the contact slides

    /// Returns the total normal force, positive for repulsion.
    double total() const { return elastic + viscous - capillary; }
};

/// Returns the forces of a contact without those of a bridge; all zero if the grains do not touch.
[[gnu::always_inline]] inline NormalForces contact_forces(const ContactKinematics& kinematics,
                                                          const PairSizes& sizes,
                                                          const Material& material) {
    const double touching = sizes.contact_distance, distance = kinematics.distance;
    const double overlap = distance < touching ? touching - distance : 0.0;
    const double gap = distance > touching ? distance - touching : 0.0;
    const Hertz hertz = hertz_contact(overlap, sizes, material.modulus);
    return {.overlap = overlap,
            .gap = gap,
            .root = hertz.root,
            .elastic = hertz.elastic,
            .viscous = viscous_force(hertz, kinematics.normal_speed, sizes, material.damping),
            .stiffness = tangential_stiffness(hertz.root, sizes, material),
            .coulomb_limit = material.friction * hertz.elastic};
}

/// Adds the bridge between two grains: sets `joined` and `capillary`.
/// @param before 1 if a bridge joined the grains before the time step, else 0
[[gnu::always_inline]] inline void add_bridge(NormalForces& forces, double before,
                                              const PairSizes& sizes, const BridgeLaw& bridges) {
    forces.joined = bridges.joined(forces.overlap, forces.gap, before);
    forces.capillary = forces.joined * bridges.of(sizes.diameter).attraction(forces.gap);
}

/// Returns the potential energy of a bridge, zero at the gap at which the bridge breaks. While the
/// grains touch, it decreases linearly with the overlap, since the attraction is then the constant
/// pull-off force.
[[gnu::always_inline]] inline double bridge_energy(const NormalForces& forces,
                                                   const PairSizes& sizes,
                                                   const BridgeLaw& bridges) {
    const BridgeLaw law = bridges.of(sizes.diameter);
    return law.potential(forces.gap) - law.pull_off_force * forces.overlap;
}

/// Tangential force of a contact after one time step, and its energies in this step.
struct TangentialStep {
    Xyz force;         ///< on the second grain
    double stored;     ///< in the tangential spring
    double sliding;    ///< lost by sliding at the Coulomb limit
    double unloading;  ///< lost without sliding (`PairEnergy::unloading`)

    /// Returns the tangential force after a time step: the force turns with the pair of grains, is
    /// projected onto the plane of contact and multiplied by `unloading_factor`; then the
    /// tangential stiffness times the tangential displacement of the step is subtracted; finally,
    /// Coulomb's law limits the force.
    /// @param force on the second grain before the step
    /// @param old_root,old_stiffness square root of the overlap and tangential stiffness before the
    ///         step
    [[gnu::always_inline]] static TangentialStep of(const Xyz& force,
                                                    const ContactKinematics& kinematics,
                                                    const NormalForces& normal, double old_root,
                                                    double old_stiffness, double dt) {
        const Xyz turned = force + dt * cross(kinematics.rotation_rate, force);
        const double along = dot(turned, kinematics.normal);
        const double kept = unloading_factor(normal.root, old_root);
        const Xyz unloaded = kept * (turned - along * kinematics.normal);
        const double increment = dt * normal.stiffness;
        const Xyz elastic = unloaded - increment * kinematics.sliding_velocity;
        const double squared = dot(elastic, elastic);
        const double allowed = coulomb_factor(squared, normal.coulomb_limit);
        const double stiffness = normal.stiffness;
        return {.force = {elastic.x * allowed, elastic.y * allowed, elastic.z * allowed},
                .stored = tangential_energy(allowed * allowed * squared, stiffness),
                .sliding = sliding_loss(squared, dot(elastic, unloaded), allowed, stiffness),
                .unloading = tangential_energy(dot(force, force), old_stiffness) -
                             tangential_energy(dot(unloaded, unloaded), stiffness)};
    }
};

/// Returns the torque of the tangential contact force of two equal grains, the same on both. For
/// unequal grains, it is multiplied by `PairSizes::first_arm()` and `second_arm()`.
/// @param tangential force on the second grain
[[gnu::always_inline]] inline Xyz contact_torque(const ContactKinematics& kinematics,
                                                 const Xyz& tangential) {
    return -(kinematics.distance * 0.5) * cross(kinematics.normal, tangential);
}

}  // namespace pendular::dem
