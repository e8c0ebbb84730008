#pragma once

#include <Eigen/Core>
#include <optional>

#include "data/formula_variant.h"

namespace pendular {

/// Annular shear cell, in which a sample is sheared between a fixed base and a rotating lid. The
/// annulus has the inner radius Ri and the outer radius Re > Ri. Shear stress and normal stress are
/// taken as uniform over the annulus, and the weight of the grains is neglected (a model can
/// include it as the effect `grain-weight`).
/// Source: Badetti et al. (2018), Eq. (3), unless stated otherwise.
struct AnnularCell {
    double inner_radius = 0;  ///< Ri [m]
    double outer_radius = 0;  ///< Re [m]
    double bead_volume = 0;   ///< V_S, solid volume of all grains in the cell [m^3]
    /// Formula that converts a torque to a shear stress. `as_printed` in Badetti et al. (2018)
    /// gives twice the shear stress of `derived`, which follows from integration over the annulus.
    FormulaVariant torque_formula = FormulaVariant::derived;
    /// Distance from the axis at which a load cell holds the lid [m]: its force times this arm is
    /// the torque. 0: the instrument gives torques.
    double lever_arm = 0;
    /// Friction coefficient between grains and side walls [1]; empty: not stated.
    std::optional<double> wall_friction = {};

    /// Returns the area [m^2] of the annulus: pi (Re^2 - Ri^2).
    double area() const;
};

/// Returns the normal stress [Pa] under the lid, from the normal force F_N [N] on the lid.
///     s22 = F_N / (pi (Re^2 - Ri^2))
double normal_stress(double normal_force, const AnnularCell& cell);

/// Returns the shear stress [Pa] from the torque T [N m] on the lid.
///     s12 = 3 T / (2 pi (Re^3 - Ri^3))      from T = int_{Ri}^{Re} 2 pi r^2 s12 dr
/// If `cell.torque_formula` is FormulaVariant::as_printed, the result is 2 s12.
/// Source: direct integration.
double shear_stress(double torque, const AnnularCell& cell);

/// Returns the solid fraction [1] of a sample of height H [m].
///     solid fraction = V_S / (pi H (Re^2 - Ri^2))
double solid_fraction(double height, const AnnularCell& cell);

/// Returns the shear rate [1/s] at the mean radius, from the angular velocity omega [rad/s] of the
/// lid and the sample height H [m].
///     shear rate = omega (Ri + Re)/(2 H)
double shear_rate(double angular_velocity, double height, const AnnularCell& cell);

/// Returns the normal force on the lid [N] at a normal stress [Pa]: inverse of `normal_stress`.
double normal_force(double normal_stress, const AnnularCell& cell);

/// Returns the torque on the lid [N m] at a shear stress [Pa]: inverse of `shear_stress` for the
/// same `cell.torque_formula`.
double torque(double shear_stress, const AnnularCell& cell);

/// Returns the sample height [m] at a solid fraction [1]: inverse of `solid_fraction`.
double height(double solid_fraction, const AnnularCell& cell);

/// Returns the angular velocity of the lid [rad/s] at a shear rate [1/s] and a sample height [m]:
/// inverse of `shear_rate`.
double angular_velocity(double shear_rate, double height, const AnnularCell& cell);

/// Returns the covariance matrix of the errors of shear stress [Pa] (index 0) and solid fraction
/// [1] (index 1), propagated to first order from the covariance matrix C of torque and height.
///     J C J^T      J = diag(d(shear stress)/d(torque), d(solid fraction)/d(height))
/// @param height sample height at which the derivatives are taken [m]
/// @param torque_height_covariance C: torque [N m] (index 0) and sample height [m] (index 1)
Eigen::Matrix2d covariance_of_reading(double height,
                                      const Eigen::Matrix2d& torque_height_covariance,
                                      const AnnularCell& cell);

}  // namespace pendular
