#pragma once

#include <algorithm>
#include <cmath>

namespace pendular::dem {

/// Material of the grains in reduced units (diameter, mass and normal stress are 1).
struct Material {
    double modulus = 0;  ///< E~ = E/(1 - nu^2) over the normal stress: kappa^(3/2)
    double poisson_ratio = 0.3;
    double friction = 0;    ///< intergranular friction coefficient mu
    double damping = 0.98;  ///< zeta, fraction of critical damping of the normal motion
};

/// Tangential over normal stiffness of a Mindlin contact [1]: (2 - 2 nu)/(2 - nu).
inline double tangential_ratio(double poisson_ratio) {
    return (2 - 2 * poisson_ratio) / (2 - poisson_ratio);
}

/// Hertz-Mindlin contact of two equal grains, reduced units; `overlap` is zero where they do not
/// touch, and then every force is zero without a branch.
///     F_N = (E~/3) h^(3/2),  K_N = dF_N/dh = (E~/2) h^(1/2),  K_T = K_N (2 - 2 nu)/(2 - nu)
///     F_viscous = zeta sqrt(2 m K_N) dh/dt                    (not clamped: it may pull)
/// Source: Badetti et al. (2018), section 2.2, and the works it cites for the simplified
/// Hertz-Mindlin law.
struct Hertz {
    double root;              ///< root of the overlap, sqrt(h)
    double elastic;           ///< elastic normal force F_N
    double normal_stiffness;  ///< normal stiffness K_N

    static Hertz at(double overlap, double modulus) {
        const double root = std::sqrt(overlap);
        return {root, modulus / 3 * overlap * root, modulus / 2 * root};
    }
    /// Elastic energy of the normal force: (2/15) E~ h^(5/2).
    double energy(double overlap) const { return 0.4 * overlap * elastic; }
    /// Viscous force for a rate of overlap dh/dt.
    double viscous(double overlap_rate, double damping) const {
        return damping * std::sqrt(2 * normal_stiffness) * overlap_rate;
    }
};

/// Factor that keeps a tangential force of squared length `squared` within the Coulomb limit
/// mu F_N on the ELASTIC normal force [1].
inline double coulomb_factor(double squared, double limit) {
    return squared > limit * limit ? limit / std::sqrt(squared) : 1.0;
}

/// Factor on the tangential force when the contact unloads: K_T(new)/K_T(old), never above 1 [1].
/// Without it a contact that opens would create elastic energy.
/// Source: the same simplified Hertz-Mindlin law as `Hertz`.
inline double unloading_factor(double root_new, double root_old) {
    return root_new < root_old ? root_new / root_old : 1.0;
}

/// Energy of a tangential force of squared length `squared` in its spring [a^3 s22].
inline double tangential_energy(double squared, double stiffness) {
    return stiffness > 0 ? squared / (2 * stiffness) : 0.0;
}

/// Energy lost by sliding when a tangential force p of squared length `squared` is cut to `allowed`
/// times itself: the displacement that is not remembered, (1 - allowed) p/K_T, times the mean of
/// the force before the step, q, and the one that is left; `along` is p q [a^3 s22].
inline double sliding_loss(double squared, double along, double allowed, double stiffness) {
    return stiffness > 0 ? 0.5 * (1 - allowed) * (allowed * squared + along) / stiffness : 0.0;
}

/// Overlap at which a contact carries the elastic normal force `force` [diameters].
inline double overlap_at(double force, double modulus) {
    return std::cbrt(3 * force / modulus * (3 * force / modulus));
}

}  // namespace pendular::dem
