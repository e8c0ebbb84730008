#pragma once

#include <algorithm>
#include <cmath>

namespace pendular::dem {

/// Material parameters of the grains in reduced units (grain diameter, grain mass and imposed
/// normal stress s22 are 1).
struct Material {
    /// E~ = E/(1 - nu^2) over s22 [1], E being Young's modulus and nu the Poisson ratio; equals
    /// kappa^(3/2), kappa being the stiffness number.
    double modulus = 0;
    double poisson_ratio = 0.3;
    double friction = 0;    ///< intergranular friction coefficient mu
    double damping = 0.98;  ///< zeta, fraction of critical damping of a contact's normal motion
};

/// Ratio of tangential to normal stiffness of a Mindlin contact of two grains of the Poisson ratio
/// nu [1]: (2 - 2 nu)/(2 - nu).
inline double tangential_ratio(double poisson_ratio) {
    return (2 - 2 * poisson_ratio) / (2 - poisson_ratio);
}

/// Hertz-Mindlin contact of two equal grains at an overlap h, reduced units. Without contact the
/// overlap is zero, and so is every force, without a branch in the code.
///     F_N = (E~/3) h^(3/2),  K_N = dF_N/dh = (E~/2) h^(1/2),  K_T = K_N (2 - 2 nu)/(2 - nu)
///     F_viscous = zeta sqrt(2 m K_N) dh/dt                    (not clamped: it may pull)
/// E~, nu and zeta are modulus, Poisson ratio and damping of Material, m is the mass of a grain.
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
    /// Elastic energy stored by the normal force of a contact with the overlap h [diameters],
    /// (2/15) E~ h^(5/2) [a^3 s22].
    double energy(double overlap) const { return 0.4 * overlap * elastic; }
    /// Viscous normal force of a contact whose overlap h grows at the rate dh/dt, for grains of
    /// unit mass [a^2 s22]; `damping` is the fraction of critical damping.
    double viscous(double overlap_rate, double damping) const {
        return damping * std::sqrt(2 * normal_stiffness) * overlap_rate;
    }
};

/// Factor [1], at most 1, that scales a tangential force of squared length `squared` down to
/// `limit`, Coulomb's limit mu F_N with the ELASTIC normal force F_N. The factor is 1 below the
/// limit.
inline double coulomb_factor(double squared, double limit) {
    return squared > limit * limit ? limit / std::sqrt(squared) : 1.0;
}

/// Factor [1], at most 1, by which the tangential force of a contact is scaled in a step in which
/// the contact unloads: tangential stiffness after the step over tangential stiffness before it.
/// `root_new` and `root_old` are the square roots of the overlap after and before the step. Without
/// this factor a contact that opens would create elastic energy.
/// Source: the simplified Hertz-Mindlin law of `Hertz`.
inline double unloading_factor(double root_new, double root_old) {
    return root_new < root_old ? root_new / root_old : 1.0;
}

/// Energy stored in the tangential spring of a contact of the tangential stiffness `stiffness`,
/// whose tangential force has the squared length `squared` [a^3 s22]; 0 if the stiffness is 0
/// (no contact).
inline double tangential_energy(double squared, double stiffness) {
    return stiffness > 0 ? squared / (2 * stiffness) : 0.0;
}

/// Energy lost by sliding in a step that cuts the tangential force p, of squared length `squared`,
/// to `allowed` p [a^3 s22]: the sliding displacement (1 - allowed) p/K_T times the mean of the
/// force q before the step and the force `allowed` p after it. `along` is the scalar product p q.
inline double sliding_loss(double squared, double along, double allowed, double stiffness) {
    return stiffness > 0 ? 0.5 * (1 - allowed) * (allowed * squared + along) / stiffness : 0.0;
}

/// Overlap [diameters] at which a Hertz contact of two equal grains carries the elastic normal
/// force `force` [a^2 s22]; `modulus` is Material::modulus.
inline double overlap_at(double force, double modulus) {
    return std::cbrt(3 * force / modulus * (3 * force / modulus));
}

}  // namespace pendular::dem
