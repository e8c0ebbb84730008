#include "data/annular_cell.h"

#include <cmath>
#include <numbers>

namespace pendular {

using std::numbers::pi;

double AnnularCell::area() const {
    return pi * (outer_radius * outer_radius - inner_radius * inner_radius);
}

double normal_stress(double normal_force, const AnnularCell& cell) {
    return normal_force / cell.area();
}

double shear_stress(double torque, const AnnularCell& cell) {
    const double derived =
        3 * torque / (2 * pi * (std::pow(cell.outer_radius, 3) - std::pow(cell.inner_radius, 3)));
    return cell.torque_formula == FormulaVariant::as_printed ? 2 * derived : derived;
}

double solid_fraction(double height, const AnnularCell& cell) {
    return cell.bead_volume / (height * cell.area());
}

double shear_rate(double angular_velocity, double height, const AnnularCell& cell) {
    return angular_velocity * (cell.inner_radius + cell.outer_radius) / (2 * height);
}

double normal_force(double normal_stress, const AnnularCell& cell) {
    return normal_stress * cell.area();
}

double torque(double shear_stress, const AnnularCell& cell) {
    // Both formulas are proportional to the torque: their factor is the shear stress at 1 N m.
    return shear_stress / pendular::shear_stress(1, cell);
}

double height(double solid_fraction, const AnnularCell& cell) {
    return cell.bead_volume / (solid_fraction * cell.area());
}

double angular_velocity(double shear_rate, double height, const AnnularCell& cell) {
    return 2 * shear_rate * height / (cell.inner_radius + cell.outer_radius);
}

Eigen::Matrix2d covariance_of_reading(double height,
                                      const Eigen::Matrix2d& torque_height_covariance,
                                      const AnnularCell& cell) {
    const Eigen::DiagonalMatrix<double, 2> derivatives(shear_stress(1, cell),
                                                       -solid_fraction(height, cell) / height);
    return derivatives * torque_height_covariance * derivatives;
}

}  // namespace pendular
