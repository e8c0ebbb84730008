#pragma once

#include <Eigen/Core>

#include "data/formula_variant.h"

namespace pendular {

/// Annular shear cell, in which the sample is sheared between a fixed base and a rotating lid:
/// radii of the annulus, and volume of the grains in the cell.
struct AnnularCell {
    double inner_radius = 0;  ///< Ri, inner radius of the annular cell [m]
    /// Re, outer radius of the annular cell [m], larger than the inner radius
    double outer_radius = 0;
    double bead_volume = 0;  ///< V_S, solid volume of all grains in the cell [m^3]
    /// Variant of the formula that converts a torque to a shear stress. The variant `derived`
    /// follows from integration over the annulus. The variant `as_printed` is printed in Badetti et
    /// al. (2018) and gives twice the shear stress of the variant `derived`.
    FormulaVariant torque_formula = FormulaVariant::derived;

    /// Returns the area [m^2] of the annulus between the inner radius Ri and the outer radius Re:
    /// pi (Re^2 - Ri^2).
    double area() const;
};

/// Returns the normal stress [Pa] under the lid, from the normal force F_N [N] on the lid.
///     s22 = F_N / (pi (Re^2 - Ri^2))      Ri, Re: inner and outer radius of the annulus [m]
/// The weight of the grains is neglected. A model can include the weight as the physical effect
/// `grain-weight`.
/// Source: Badetti et al. (2018), Eq. (3).
double normal_stress(double normal_force, const AnnularCell& cell);

/// Returns the shear stress [Pa] from the torque T [N m] on the lid. The shear stress is assumed to
/// be uniform over the annulus with the inner radius Ri and the outer radius Re [m].
///     s12 = 3 T / (2 pi (Re^3 - Ri^3))      from T = int_{Ri}^{Re} 2 pi r^2 s12 dr
/// If `cell.torque_formula` is FormulaVariant::as_printed, the result is 2 s12.
/// Source: direct integration.
double shear_stress(double torque, const AnnularCell& cell);

/// Returns the solid fraction [1] of a sample of height H [m]: volume V_S of the grains divided by
/// the volume of the sample.
///     solid fraction = V_S / (pi H (Re^2 - Ri^2))      Ri, Re: inner and outer radius [m]
/// Source: Badetti et al. (2018), Eq. (3).
double solid_fraction(double height, const AnnularCell& cell);

/// Returns the shear rate [1/s] at the mean radius of the annulus, from the angular velocity omega
/// [rad/s] of the lid and the sample height H [m].
///     shear rate = omega (Ri + Re)/(2 H)      Ri, Re: inner and outer radius of the annulus [m]
/// Source: Badetti et al. (2018), Eq. (3).
double shear_rate(double angular_velocity, double height, const AnnularCell& cell);

/// Returns the normal force on the lid [N] that causes a given normal stress under the lid [Pa]:
/// normal stress times the area of the annulus. The function inverts `normal_stress`.
double normal_force(double normal_stress, const AnnularCell& cell);

/// Returns the torque on the lid [N m] that causes a given shear stress [Pa], uniform over the
/// annulus. The function inverts `shear_stress` for the same `cell.torque_formula`.
double torque(double shear_stress, const AnnularCell& cell);

/// Returns the height of the sample [m] at which the grains in the cell have a given solid fraction
/// [1]. The function inverts `solid_fraction`.
double height(double solid_fraction, const AnnularCell& cell);

/// Returns the angular velocity of the lid [rad/s] that causes a given shear rate at the mean
/// radius of the annulus [1/s] at a given sample height [m]. The function inverts `shear_rate`.
double angular_velocity(double shear_rate, double height, const AnnularCell& cell);

/// Returns the covariance matrix of the errors of a reading (mean over a step of steady shear):
/// shear stress [Pa] (index 0) and solid fraction [1] (index 1). The function propagates the errors
/// of torque and sample height, with the covariance matrix C, to first order.
///     J C J^T      J = diag(d(shear stress)/d(torque), d(solid fraction)/d(height))
/// @param height sample height at which the derivatives are taken [m]
/// @param torque_height_covariance covariance matrix C of the errors of torque [N m] (index 0) and
///        sample height [m] (index 1)
Eigen::Matrix2d covariance_of_reading(double height,
                                      const Eigen::Matrix2d& torque_height_covariance,
                                      const AnnularCell& cell);

}  // namespace pendular
