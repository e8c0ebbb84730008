#pragma once

#include <cmath>

#include "sim/dem/bridge_law.h"
#include "sim/dem/contact_law.h"
#include "sim/dem/flow.h"
#include "sim/dem/pair_sizes.h"

// Laws of contact and bridge for one pair of grains, in reduced units (grain diameter, grain mass
// and imposed normal stress are 1). The loops over pairs (pair_forces.cpp, viscous_loss.cpp) inline
// these functions and process many pairs at once in vector lanes. Functions here must therefore not
// branch, nor call a function that has no vector instruction.
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

/// Relative position and velocities of two grains in reduced units (grain diameter, grain mass and
/// imposed normal stress are 1).
struct PairMotion {
    /// Vector from the centre of the first grain to the centre of the second grain [grain
    /// diameters].
    Xyz separation;
    /// Velocity of the second grain minus the velocity of the first grain, without the imposed
    /// flow, in reduced units.
    Xyz velocity;
    /// Sum of the angular velocities of the two grains, in reduced units. For unequal grains, the
    /// angular velocity of each grain is weighted with the distance from the grain's centre to the
    /// contact point, divided by half the distance between the centres.
    Xyz angular_velocity;
};

/// Distance, direction and relative velocities of two grains, including the imposed flow, in
/// reduced units (grain diameter, grain mass and imposed normal stress are 1).
struct ContactKinematics {
    double distance;  ///< distance between the centres of the two grains [grain diameters]
    Xyz normal;       ///< unit vector from the first to the second grain's centre [1]
    /// Rate at which the distance between the grains' centres grows, in reduced units.
    double normal_speed;
    /// Tangential velocity, at the contact point, of the second grain's surface relative to the
    /// first grain's surface, in reduced units.
    Xyz sliding_velocity;
    /// Angular velocity with which the pair of grains rotates as a whole, including the rotation
    /// about the line of centres, in reduced units.
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

/// Returns the elastic normal force and the normal stiffness of a Hertz contact between two grains
/// of any sizes, in reduced units (grain diameter, grain mass and imposed normal stress are 1).
/// Grains of the diameters d1 and d2 have the stiffness of two equal grains of the diameter 2 d1
/// d2/(d1 + d2).
/// @param overlap overlap of the grains [grain diameters]
/// @param modulus E/(1 - nu^2) divided by the imposed normal stress [1], with Young's modulus E and
///         Poisson ratio nu
[[gnu::always_inline]] inline Hertz hertz_contact(double overlap, const PairSizes& sizes,
                                                  double modulus) {
    return Hertz::at(overlap, modulus * std::sqrt(sizes.diameter));
}

/// Returns the tangential stiffness of a contact (tangential force divided by tangential
/// displacement), in units of a s22, with grain diameter a and imposed normal stress s22.
/// @param root square root of (overlap divided by grain diameter) [1]
[[gnu::always_inline]] inline double tangential_stiffness(double root, const PairSizes& sizes,
                                                          const Material& material) {
    const double modulus = material.modulus * std::sqrt(sizes.diameter);
    return tangential_ratio(material.poisson_ratio) * (modulus / 2 * root);
}

/// Returns the viscous normal force of a contact in units of a^2 s22, with grain diameter a and
/// imposed normal stress s22. The force is positive while the grains approach each other.
/// @param normal_speed rate at which the distance between the centres grows, in reduced units
///         (grain diameter, grain mass and imposed normal stress are 1)
/// @param damping fraction of critical damping [1]
[[gnu::always_inline]] inline double viscous_force(const Hertz& hertz, double normal_speed,
                                                   const PairSizes& sizes, double damping) {
    return hertz.viscous(-normal_speed, damping) * std::sqrt(sizes.mass);
}

/// Normal forces of a pair of grains, and the quantities on which the tangential force of the pair
/// depends, in reduced units (grain diameter, grain mass and imposed normal stress are 1). All
/// forces are zero for a pair with neither contact nor bridge.
struct NormalForces {
    double overlap;  ///< overlap of the two grains [grain diameters], 0 without contact
    double gap;      ///< gap between the surfaces of the two grains [grain diameters], 0 in contact
    double root;     ///< square root of (`overlap` divided by the grain diameter) [1]
    double elastic;  ///< elastic normal force of the contact, a repulsion, in reduced units
    /// Viscous normal force of the contact, positive for repulsion, in reduced units.
    double viscous;
    double joined = 0;  ///< 1 if a liquid bridge joins the grains, else 0
    /// Attraction of the two grains by the liquid bridge, in reduced units; 0 without bridge.
    double capillary = 0;
    double stiffness;  ///< tangential stiffness of the contact, in reduced units
    /// Largest tangential force of the contact, at which the contact slides, in reduced units.
    double coulomb_limit;

    /// Returns the total normal force of the pair, positive for repulsion, in units of a^2 s22,
    /// with grain diameter a and imposed normal stress s22.
    double total() const { return elastic + viscous - capillary; }
};

/// Returns the forces of a contact between two grains, without the force of a bridge. The forces
/// are the elastic normal force, the viscous normal force and the Coulomb limit, together with the
/// tangential stiffness, in reduced units (grain diameter, grain mass and imposed normal stress are
/// 1). All these quantities are zero if the grains do not touch.
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

/// Adds the liquid bridge between two grains to the forces of the pair. Sets `forces.joined` to 1
/// if a bridge joins the grains, else to 0. Sets `forces.capillary` to the attraction by the bridge
/// in units of a^2 s22, with grain diameter a and imposed normal stress s22.
/// @param before 1 if a bridge joined the grains before the time step, else 0
[[gnu::always_inline]] inline void add_bridge(NormalForces& forces, double before,
                                              const PairSizes& sizes, const BridgeLaw& bridges) {
    forces.joined = bridges.joined(forces.overlap, forces.gap, before);
    forces.capillary = forces.joined * bridges.of(sizes.diameter).attraction(forces.gap);
}

/// Returns the potential energy of a bridge between two grains, in units of a^3 s22, with grain
/// diameter a and imposed normal stress s22. The energy is zero at the gap at which the bridge
/// breaks. While the grains touch, the energy decreases linearly with the overlap, since the
/// attraction is then the constant pull-off force.
[[gnu::always_inline]] inline double bridge_energy(const NormalForces& forces,
                                                   const PairSizes& sizes,
                                                   const BridgeLaw& bridges) {
    const BridgeLaw law = bridges.of(sizes.diameter);
    return law.potential(forces.gap) - law.pull_off_force * forces.overlap;
}

/// Tangential force of a contact after one time step, and energies of the contact in this time
/// step, in reduced units (grain diameter, grain mass and imposed normal stress are 1).
struct TangentialStep {
    /// Tangential force on the second grain of the pair after the time step, in reduced units.
    Xyz force;
    /// Energy stored in the tangential spring of the contact after the time step, in reduced units.
    double stored;
    /// Energy that the contact loses in the time step by sliding at the Coulomb limit, in reduced
    /// units.
    double sliding;
    /// Energy that the tangential spring of the contact loses in the time step without sliding, in
    /// reduced units (`PairEnergy::unloading`).
    double unloading;

    /// Returns the tangential force of a contact after one time step, with the energies of the
    /// contact. The function rotates the force with the pair of grains, projects the force onto the
    /// plane of contact, and multiplies the force by `unloading_factor`. The function then
    /// subtracts the tangential stiffness times the tangential displacement in the step. Finally,
    /// Coulomb's law limits the force.
    /// @param force tangential force on the second grain before the time step, in reduced units
    /// @param old_root square root of (overlap divided by grain diameter) before the time step [1]
    /// @param old_stiffness tangential stiffness before the time step, in reduced units
    /// @param dt length of the time step, in reduced units
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

/// Returns the torque that the tangential contact force of two equal grains exerts on each grain,
/// in units of a^3 s22, with grain diameter a and imposed normal stress s22. The torques on the two
/// grains are equal.
/// @param tangential tangential force on the second grain; the opposite force acts on the first
///         grain
[[gnu::always_inline]] inline Xyz contact_torque(const ContactKinematics& kinematics,
                                                 const Xyz& tangential) {
    return -(kinematics.distance * 0.5) * cross(kinematics.normal, tangential);
}

}  // namespace pendular::dem
