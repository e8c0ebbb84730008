#pragma once

#include <algorithm>
#include <cmath>

namespace pendular::dem {

/// Material parameters of the grains in reduced units (grain diameter, grain mass and imposed
/// normal stress are 1).
struct Material {
    /// Reduced elastic modulus of the grains [1]: E/(1 - nu^2) divided by the imposed normal
    /// stress, with Young's modulus E and Poisson ratio nu. The reduced modulus equals the
    /// stiffness number to the power 3/2.
    double modulus = 0;
    double poisson_ratio = 0.3;  ///< Poisson ratio nu of the grain material [1]
    double friction = 0;         ///< friction coefficient between grains [1]
    /// Damping coefficient of the normal motion in contacts, divided by the coefficient of critical
    /// damping [1].
    double damping = 0.98;
};

/// Returns the ratio of tangential to normal stiffness of a Mindlin contact [1]: (2 - 2 nu)/(2 -
/// nu), with the Poisson ratio nu of the grains.
inline double tangential_ratio(double poisson_ratio) {
    return (2 - 2 * poisson_ratio) / (2 - poisson_ratio);
}

/// Normal force and normal stiffness of a contact of two equal grains, in reduced units (grain
/// diameter, grain mass and imposed normal stress are 1).
///     F_N = (E~/3) h^(3/2),  K_N = dF_N/dh = (E~/2) h^(1/2),  K_T = K_N (2 - 2 nu)/(2 - nu)
///     F_viscous = zeta sqrt(2 m K_N) dh/dt                    (may be an attraction)
/// F_N is the elastic normal force, h the overlap, K_N the normal stiffness, and K_T the tangential
/// stiffness. E~ = E/(1 - nu^2) follows from Young's modulus E and Poisson ratio nu. F_viscous is
/// the viscous normal force, with the fraction zeta of critical damping and the grain mass m.
/// Without contact, h and all forces are zero.
/// Source: Badetti et al. (2018), section 2.2 (simplified Hertz-Mindlin law).
struct Hertz {
    double root;              ///< square root of (overlap divided by grain diameter) [1]
    double elastic;           ///< elastic normal force of the contact, in reduced units
    double normal_stiffness;  ///< normal stiffness of the contact, in reduced units

    static Hertz at(double overlap, double modulus) {
        const double root = std::sqrt(overlap);
        return {root, modulus / 3 * overlap * root, modulus / 2 * root};
    }
    /// Returns the elastic energy (2/15) E~ h^(5/2) that the normal force of a contact stores, in
    /// units of a^3 s22, with grain diameter a and imposed normal stress s22.
    /// @param overlap overlap h of the contact [grain diameters]
    double energy(double overlap) const { return 0.4 * overlap * elastic; }
    /// Returns the viscous normal force of a contact between grains of unit mass, positive for
    /// repulsion, in units of a^2 s22, with grain diameter a and imposed normal stress s22.
    /// @param overlap_rate rate at which the overlap grows, in reduced units
    /// @param damping fraction of critical damping [1]
    double viscous(double overlap_rate, double damping) const {
        return damping * std::sqrt(2 * normal_stiffness) * overlap_rate;
    }
};

/// Returns the factor [1], at most 1, by which a tangential force must be multiplied so that the
/// magnitude of the force does not exceed Coulomb's limit.
/// @param squared squared magnitude of the tangential force
/// @param limit Coulomb's limit: friction coefficient times elastic normal force (the viscous
///         normal force is not included)
inline double coulomb_factor(double squared, double limit) {
    return squared > limit * limit ? limit / std::sqrt(squared) : 1.0;
}

/// Returns the factor [1] by which the tangential force of a contact is multiplied in a time step.
/// If the overlap falls, the factor is the tangential stiffness after the step divided by the
/// tangential stiffness before the step. Otherwise the factor is 1. Without this factor, a contact
/// that opens would create elastic energy.
/// @param root_new,root_old square root of the overlap after and before the time step
/// Source: Badetti et al. (2018), section 2.2 (simplified Hertz-Mindlin law).
inline double unloading_factor(double root_new, double root_old) {
    return root_new < root_old ? root_new / root_old : 1.0;
}

/// Returns the energy stored in the tangential spring of a contact, in units of a^3 s22, with grain
/// diameter a and imposed normal stress s22. The energy is 0 if the stiffness is 0 (no contact).
/// @param squared squared magnitude of the tangential force
/// @param stiffness tangential stiffness of the contact
inline double tangential_energy(double squared, double stiffness) {
    return stiffness > 0 ? squared / (2 * stiffness) : 0.0;
}

/// Returns the energy that a contact loses by sliding in a time step, in units of a^3 s22, with
/// grain diameter a and imposed normal stress s22.
///     energy = [(1 - allowed) p/stiffness] . [(q + allowed p)/2]
/// The first factor is the sliding displacement, the second factor the mean tangential force. The
/// vector q is the tangential force before the tangential displacement of the time step. The vector
/// p is the tangential force after this displacement if the contact did not slide. Coulomb's limit
/// reduces p to `allowed` times p.
/// @param squared squared magnitude of p
/// @param along scalar product of p and q
/// @param allowed factor by which p is reduced [1]
/// @param stiffness tangential stiffness of the contact; if it is 0 (no contact), the energy is 0
inline double sliding_loss(double squared, double along, double allowed, double stiffness) {
    return stiffness > 0 ? 0.5 * (1 - allowed) * (allowed * squared + along) / stiffness : 0.0;
}

/// Returns the overlap [grain diameters] at which the Hertz contact of two equal grains has the
/// elastic normal force `force`.
/// @param force elastic normal force in units of a^2 s22, with grain diameter a and imposed normal
///         stress s22
/// @param modulus E/(1 - nu^2) divided by s22 [1], with Young's modulus E and Poisson ratio nu
inline double overlap_at(double force, double modulus) {
    return std::cbrt(3 * force / modulus * (3 * force / modulus));
}

}  // namespace pendular::dem
