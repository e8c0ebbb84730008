#pragma once

#include <Eigen/Core>

#include "data/formula_variant.h"

namespace pendular {

/// Annular shear cell: radii of the annulus, and volume of the grains in it. The sample is sheared
/// between a fixed base and a rotating lid.
struct AnnularCell {
    double inner_radius = 0;  ///< Ri, inner radius of the annular cell [m]
    double outer_radius = 0;  ///< Re > Ri, outer radius of the annular cell [m]
    double bead_volume = 0;   ///< V_S, solid volume of all grains in the cell [m^3]
    /// Formula that converts a torque to a shear stress: derived by integration over the annulus,
    /// or as Badetti et al. (2018) print it, which gives twice the derived value.
    FormulaVariant torque_formula = FormulaVariant::derived;

    /// Area of the annulus between the inner radius Ri and the outer radius Re [m^2]: pi (Re^2 -
    /// Ri^2).
    double area() const;
};

/// Normal stress [Pa] under the lid from the normal force F_N [N] on the lid.
///     s22 = F_N / (pi (Re^2 - Ri^2))      Ri, Re: inner and outer radius of the annulus [m]
/// The weight of the grains is not included; the effect `grain-weight` describes it.
/// Source: Badetti et al. (2018), eq:exprheol.
double normal_stress(double normal_force, const AnnularCell& cell);

/// Shear stress [Pa] from the torque T [N m] on the lid, for a stress that is uniform over the
/// annulus with inner radius Ri and outer radius Re [m].
///     s12 = 3 T / (2 pi (Re^3 - Ri^3))      from T = int_{Ri}^{Re} 2 pi r^2 s12 dr
/// If `cell.torque_formula` is FormulaVariant::as_printed, the function returns twice this value,
/// as Badetti et al. (2018) print it.
/// Source: direct integration.
double shear_stress(double torque, const AnnularCell& cell);

/// Solid fraction [1] of a sample of height H [m]: volume V_S of the grains divided by the volume
/// of the sample.
///     solid fraction = V_S / (pi H (Re^2 - Ri^2))      Ri, Re: inner and outer radius [m]
/// Source: Badetti et al. (2018), eq:exprheol.
double solid_fraction(double height, const AnnularCell& cell);

/// Shear rate [1/s] at the mean radius, from the angular velocity omega [rad/s] of the lid and the
/// sample height H [m].
///     shear rate = omega (Ri + Re)/(2 H)      Ri, Re: inner and outer radius of the annulus [m]
/// Source: Badetti et al. (2018), eq:exprheol.
double shear_rate(double angular_velocity, double height, const AnnularCell& cell);

/// Normal force on the lid [N] at a normal stress under the lid [Pa]: normal stress times the area
/// of the annulus. The inverse of `normal_stress`.
double normal_force(double normal_stress, const AnnularCell& cell);

/// Torque on the lid [N m] at a shear stress [Pa] that is uniform over the annulus. The inverse of
/// `shear_stress`, with the formula `cell.torque_formula`.
double torque(double shear_stress, const AnnularCell& cell);

/// Height of the sample [m] in which the grains in the cell have a given solid fraction [1]. The
/// inverse of `solid_fraction`.
double height(double solid_fraction, const AnnularCell& cell);

/// Angular velocity of the lid [rad/s] at a shear rate at the mean radius [1/s] and a sample height
/// [m]. The inverse of `shear_rate`.
double angular_velocity(double shear_rate, double height, const AnnularCell& cell);

/// Covariance matrix (2 x 2) of the errors of (shear stress [Pa], solid fraction [1]). It follows
/// to first order from the covariance matrix C of the errors of (torque [N m], sample height [m]).
///     J C J^T      J = diag(d(shear stress)/d(torque), d(solid fraction)/d(height))
/// @param height sample height at which the derivatives are taken [m]
Eigen::Matrix2d covariance_of_reading(double height,
                                      const Eigen::Matrix2d& torque_height_covariance,
                                      const AnnularCell& cell);

}  // namespace pendular
