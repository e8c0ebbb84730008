#pragma once

#include <Eigen/Core>

#include "data/formula_variant.h"

namespace pendular {

/// Annular shear cell between radii inner < outer [m], holding beads of a total volume [m^3].
struct AnnularCell {
    double inner_radius = 0;
    double outer_radius = 0;
    double bead_volume = 0;
    FormulaVariant torque_formula = FormulaVariant::derived;

    /// Area of the annulus [m^2]: pi (Re^2 - Ri^2).
    double area() const;
};

/// Normal stress of an annular cell from its normal force [Pa].
///     s22 = F_N / (pi (Re^2 - Ri^2))
/// The beads' own weight is left to the effect `grain-weight`.
/// Source: Badetti et al. (2018), eq:exprheol.
double normal_stress(double normal_force, const AnnularCell& cell);

/// Magnitude of the shear stress of an annular cell from its torque, stress uniform over the
/// annulus [Pa].
///     s12 = 3 T / (2 pi (Re^3 - Ri^3))      from T = int_{Ri}^{Re} 2 pi r^2 s12 dr
/// Source: direct integration; Badetti et al. (2018) print twice this value
/// (FormulaVariant::as_printed).
double shear_stress(double torque, const AnnularCell& cell);

/// Bead volume over sample volume [1]: V_S / (pi H (Re^2 - Ri^2)).
/// Source: Badetti et al. (2018), eq:exprheol.
double solid_fraction(double height, const AnnularCell& cell);

/// Shear rate at the mean radius [1/s]: omega (Ri + Re)/(2 H).
/// Source: Badetti et al. (2018), eq:exprheol.
double shear_rate(double angular_velocity, double height, const AnnularCell& cell);

/// Normal force on the lid [N] at a normal stress [Pa]; the inverse of `normal_stress`.
double normal_force(double normal_stress, const AnnularCell& cell);

/// Torque on the lid [N m] at a shear stress [Pa], in the cell's form of the formula; the inverse
/// of `shear_stress`.
double torque(double shear_stress, const AnnularCell& cell);

/// Height of the sample [m] at a solid fraction [1]; the inverse of `solid_fraction`.
double height(double solid_fraction, const AnnularCell& cell);

/// Angular velocity of the lid [rad/s] at a shear rate [1/s] and a height [m]; the inverse of
/// `shear_rate`.
double angular_velocity(double shear_rate, double height, const AnnularCell& cell);

/// First-order covariance of (shear stress [Pa], solid fraction [1]) from that of
/// (torque [N m], height [m]): J C J^T with the derivatives of the two conversions.
Eigen::Matrix2d covariance_of_reading(double height,
                                      const Eigen::Matrix2d& torque_height_covariance,
                                      const AnnularCell& cell);

}  // namespace pendular
