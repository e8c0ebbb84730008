#pragma once

#include <algorithm>
#include <cmath>

namespace pendular::dem {

/// Material of the grains. This file is in reduced units, in which grain diameter a, grain mass m
/// and imposed normal stress s22 are 1: forces in a^2 s22, energies in a^3 s22.
struct Material {
    /// E/(1 - nu^2) over s22 [1], with Young's modulus E and Poisson ratio nu; the stiffness number
    /// to the power 3/2.
    double modulus = 0;
    double poisson_ratio = 0.3;  ///< nu
    double friction = 0;         ///< friction coefficient between grains
    double damping = 0.98;       ///< of the normal motion in contacts, over critical damping
};

/// Returns the ratio of tangential to normal stiffness of a Mindlin contact [1].
inline double tangential_ratio(double poisson_ratio) {
    return (2 - 2 * poisson_ratio) / (2 - poisson_ratio);
}

/// Normal force and normal stiffness of a contact of two equal grains.
///     F_N = (E~/3) h^(3/2),  K_N = dF_N/dh = (E~/2) h^(1/2),  K_T = K_N (2 - 2 nu)/(2 - nu)
///     F_viscous = zeta sqrt(2 m K_N) dh/dt                    (may be an attraction)
/// h is the overlap, 0 without contact, K_T the tangential stiffness, E~ the modulus of `Material`,
/// and zeta the fraction of critical damping.
/// Source: Badetti et al. (2018), section 2.2 (simplified Hertz-Mindlin law).
struct Hertz {
    double root;              ///< square root of the overlap
    double elastic;           ///< F_N
    double normal_stiffness;  ///< K_N

    static Hertz at(double overlap, double modulus) {
        const double root = std::sqrt(overlap);
        return {root, modulus / 3 * overlap * root, modulus / 2 * root};
    }
    /// Returns the elastic energy (2/15) E~ h^(5/2) that the normal force of a contact stores.
    double energy(double overlap) const { return 0.4 * overlap * elastic; }
    /// Returns the viscous normal force between grains of unit mass, positive for repulsion.
    /// @param damping fraction of critical damping [1]
    double viscous(double overlap_rate, double damping) const {
        return damping * std::sqrt(2 * normal_stiffness) * overlap_rate;
    }
};

/// Returns the factor [1], at most 1, that limits a tangential force to Coulomb's limit.
/// @param squared squared magnitude of the tangential force
/// @param limit friction coefficient times elastic normal force, without the viscous one
inline double coulomb_factor(double squared, double limit) {
    return squared > limit * limit ? limit / std::sqrt(squared) : 1.0;
}

/// Returns the factor [1] by which the tangential force is multiplied in a time step: if the
/// overlap falls, the ratio of the tangential stiffnesses after and before, else 1. Without it, a
/// contact that opens would create elastic energy.
/// @param root_new,root_old square root of the overlap after and before the time step
/// Source: Badetti et al. (2018), section 2.2 (simplified Hertz-Mindlin law).
inline double unloading_factor(double root_new, double root_old) {
    return root_new < root_old ? root_new / root_old : 1.0;
}

/// Returns the energy stored in the tangential spring of a contact; 0 if the stiffness is 0.
/// @param squared squared magnitude of the tangential force
inline double tangential_energy(double squared, double stiffness) {
    return stiffness > 0 ? squared / (2 * stiffness) : 0.0;
}

/// Returns the energy that a contact loses by sliding in a time step: sliding displacement times
/// mean tangential force.
///     energy = [(1 - allowed) p/stiffness] . [(q + allowed p)/2]
/// q is the tangential force before the tangential displacement of the time step, p the one after
/// it if the contact did not slide. Coulomb's limit reduces p to `allowed` times p.
/// @param squared squared magnitude of p
/// @param along scalar product of p and q
/// @param stiffness tangential stiffness; if it is 0 (no contact), the energy is 0
inline double sliding_loss(double squared, double along, double allowed, double stiffness) {
    return stiffness > 0 ? 0.5 * (1 - allowed) * (allowed * squared + along) / stiffness : 0.0;
}

/// Returns the overlap at which the Hertz contact of two equal grains has the elastic normal force
/// `force`, for the `modulus` of `Material`.
inline double overlap_at(double force, double modulus) {
    return std::cbrt(3 * force / modulus * (3 * force / modulus));
}

}  // namespace pendular::dem
