#pragma once

#include <cmath>

#include "sim/dem/bridge_law.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/flow.h"
#include "sim/dem/pair_sizes.h"

// Contact and bridge of one pair of grains in reduced units. The loops over pairs (pair_forces.cpp,
// viscous_loss.cpp) inline these functions and process many pairs at a time. No function here may
// therefore branch, or call a function that has no vector instruction.
namespace pendular::dem {

/// Vector as three plain numbers, which the compiler turns into SIMD lanes in a loop over pairs.
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

/// Positions and velocities of two grains relative to each other, reduced units (grain diameter,
/// mass and imposed normal stress are 1).
struct PairMotion {
    Xyz separation;  ///< vector from the first to the second centre
    Xyz velocity;  ///< velocity of the second centre minus that of the first, imposed flow excluded
    Xyz angular_velocity;  ///< sum of the grains' angular velocities, each weighted with its arm
                           ///< (PairSizes)
};

/// Geometry and relative velocities of a pair, imposed flow included, reduced units.
struct ContactKinematics {
    double distance;       ///< distance of the centres
    Xyz normal;            ///< unit vector from the first to the second centre
    double normal_speed;   ///< rate at which the distance of the centres grows
    Xyz sliding_velocity;  ///< velocity of the second surface minus that of the first, at the
                           ///< contact point
    Xyz rotation_rate;     ///< angular velocity of the pair, including rotation about its normal

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

/// Elastic normal force and normal stiffness of a Hertz contact of two grains, of any sizes, at an
/// overlap [diameters] and a modulus [s22]. Unequal spheres have the stiffness of equal spheres of
/// the diameter 2 d1 d2/(d1 + d2).
[[gnu::always_inline]] inline Hertz hertz_contact(double overlap, const PairSizes& sizes,
                                                  double modulus) {
    return Hertz::at(overlap, modulus * std::sqrt(sizes.diameter));
}

/// Tangential stiffness K_T of a contact, tangential force over sliding displacement [a s22];
/// `root` is the square root of its overlap over the grain diameter a.
[[gnu::always_inline]] inline double tangential_stiffness(double root, const PairSizes& sizes,
                                                          const Material& material) {
    const double modulus = material.modulus * std::sqrt(sizes.diameter);
    return tangential_ratio(material.poisson_ratio) * (modulus / 2 * root);
}

/// Viscous normal force of a contact, positive while the grains approach each other [a^2 s22];
/// `normal_speed` is the rate at which the distance of their centres grows, `damping` the fraction
/// of critical damping.
[[gnu::always_inline]] inline double viscous_force(const Hertz& hertz, double normal_speed,
                                                   const PairSizes& sizes, double damping) {
    return hertz.viscous(-normal_speed, damping) * std::sqrt(sizes.mass);
}

/// Normal forces of a pair and the quantities that its tangential force depends on, reduced units.
/// Without contact and bridge all forces are zero, without a branch in the code.
struct NormalForces {
    double overlap;        ///< overlap of the grains; 0 without contact
    double gap;            ///< gap between the surfaces; 0 in contact
    double root;           ///< square root of `overlap`
    double elastic;        ///< elastic normal force F_N of the contact, a repulsion
    double viscous;        ///< viscous normal force of the contact, positive for repulsion
    double joined = 0;     ///< 1 where a liquid bridge joins the grains, else 0
    double capillary = 0;  ///< attraction by the liquid bridge; 0 without bridge
    double stiffness;      ///< tangential stiffness K_T of the contact
    double coulomb_limit;  ///< largest tangential force that the contact carries before it slides

    /// Total normal force, positive where it drives the grains apart [a^2 s22].
    double total() const { return elastic + viscous - capillary; }
};

/// Elastic and viscous normal force, tangential stiffness and Coulomb limit of a pair of grains
/// without bridge, reduced units; all are zero without contact.
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

/// Sets `forces.joined` and `forces.capillary`, the attraction by a liquid bridge [a^2 s22]. A
/// bridge joins the grains if they touch, or if a bridge joined them at the step before (`before`:
/// 1 or 0) and has not ruptured.
[[gnu::always_inline]] inline void add_bridge(NormalForces& forces, double before,
                                              const PairSizes& sizes, const BridgeLaw& bridges) {
    forces.joined = bridges.joined(forces.overlap, forces.gap, before);
    forces.capillary = forces.joined * bridges.of(sizes.diameter).attraction(forces.gap);
}

/// Potential energy of a bridge between the grains of a pair, zero at rupture [a^3 s22]. In contact
/// it decreases linearly with the overlap, as the attraction is then the pull-off force.
[[gnu::always_inline]] inline double bridge_energy(const NormalForces& forces,
                                                   const PairSizes& sizes,
                                                   const BridgeLaw& bridges) {
    const BridgeLaw law = bridges.of(sizes.diameter);
    return law.potential(forces.gap) - law.pull_off_force * forces.overlap;
}

/// Tangential force of a contact after one step, with the energies of that step [a^3 s22].
struct TangentialStep {
    Xyz force;         ///< tangential force on the second grain after the step
    double stored;     ///< energy in the tangential spring after the step
    double sliding;    ///< energy lost by sliding at the Coulomb limit
    double unloading;  ///< energy lost by the spring without sliding (PairEnergy::unloading)

    /// Advances the tangential force `force` of the step before by a step of length `dt`. The force
    /// rotates with the pair and about its normal, and its component along the new normal is
    /// removed. It is scaled down when the contact unloads, grows against the sliding velocity and
    /// is limited by Coulomb's law. `old_root` and `old_stiffness` are sqrt(overlap) and K_T of the
    /// step before.
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

/// Torque on each grain of a pair by the tangential force `tangential` that acts on the second
/// grain (its opposite acts on the first), for grains of equal size [a^3 s22].
[[gnu::always_inline]] inline Xyz contact_torque(const ContactKinematics& kinematics,
                                                 const Xyz& tangential) {
    return -(kinematics.distance * 0.5) * cross(kinematics.normal, tangential);
}

}  // namespace pendular::dem
