#pragma once

#include <algorithm>
#include <cmath>

namespace pendular::dem {

/// Material parameters of the grains in reduced units (diameter, mass and normal stress are 1).
struct Material {
    double modulus = 0;  ///< E~ = E/(1 - nu^2) over the normal stress s22; equals kappa^(3/2)
    double poisson_ratio = 0.3;
    double friction = 0;    ///< intergranular friction coefficient mu
    double damping = 0.98;  ///< zeta, fraction of critical damping of the normal motion
};

/// Ratio of tangential to normal stiffness of a Mindlin contact [1]: (2 - 2 nu)/(2 - nu).
inline double tangential_ratio(double poisson_ratio) {
    return (2 - 2 * poisson_ratio) / (2 - poisson_ratio);
}

/// Hertz-Mindlin contact of two equal grains at an overlap h, reduced units. Without contact the
/// overlap is zero, and so is every force, without a branch in the code.
///     F_N = (E~/3) h^(3/2),  K_N = dF_N/dh = (E~/2) h^(1/2),  K_T = K_N (2 - 2 nu)/(2 - nu)
///     F_viscous = zeta sqrt(2 m K_N) dh/dt                    (not clamped: it may pull)
/// Source: Badetti et al. (2018), section 2.2, and the works it cites for the simplified
/// Hertz-Mindlin law.
struct Hertz {
    double root;              ///< square root of the overlap, sqrt(h)
    double elastic;           ///< elastic normal force F_N
    double normal_stiffness;  ///< normal stiffness K_N

    static Hertz at(double overlap, double modulus) {
        const double root = std::sqrt(overlap);
        return {root, modulus / 3 * overlap * root, modulus / 2 * root};
    }
    /// Elastic energy of the normal force, (2/15) E~ h^(5/2) [a^3 s22].
    double energy(double overlap) const { return 0.4 * overlap * elastic; }
    /// Viscous normal force at the rate dh/dt of the overlap, for grains of unit mass [a^2 s22].
    double viscous(double overlap_rate, double damping) const {
        return damping * std::sqrt(2 * normal_stiffness) * overlap_rate;
    }
};

/// Factor, at most 1, that scales a tangential force of squared length `squared` down to the
/// Coulomb limit [1]. The limit is mu F_N, F_N being the ELASTIC part of the normal force.
inline double coulomb_factor(double squared, double limit) {
    return squared > limit * limit ? limit / std::sqrt(squared) : 1.0;
}

/// Factor K_T(new)/K_T(old), at most 1, on the tangential force of a contact that unloads, from the
/// square roots of its overlap after and before a step [1]. Without the factor a contact that opens
/// would create elastic energy. Source: the simplified Hertz-Mindlin law of `Hertz`.
inline double unloading_factor(double root_new, double root_old) {
    return root_new < root_old ? root_new / root_old : 1.0;
}

/// Energy in the tangential spring of a contact whose tangential force has the squared length
/// `squared` [a^3 s22]; 0 without contact.
inline double tangential_energy(double squared, double stiffness) {
    return stiffness > 0 ? squared / (2 * stiffness) : 0.0;
}

/// Energy lost by sliding in a step that cuts the tangential force p, of squared length `squared`,
/// to `allowed` p [a^3 s22]: the sliding displacement (1 - allowed) p/K_T times the mean of the
/// force q before the step and the force `allowed` p after it. `along` is the scalar product p q.
inline double sliding_loss(double squared, double along, double allowed, double stiffness) {
    return stiffness > 0 ? 0.5 * (1 - allowed) * (allowed * squared + along) / stiffness : 0.0;
}

/// Overlap at which a contact carries the elastic normal force `force` [diameters].
inline double overlap_at(double force, double modulus) {
    return std::cbrt(3 * force / modulus * (3 * force / modulus));
}

}  // namespace pendular::dem
