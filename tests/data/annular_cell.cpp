#include "data/annular_cell.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "data/study/study.h"

namespace pendular::data_annular_cell_test {

const AnnularCell cell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 5.7e-5};

TEST(AnnularCell, IntegratesAUniformShearStressToItsTorque) {
    // T = int 2 pi r^2 s12 dr over the annulus, by the midpoint rule: error O(1e-8).
    const double stress = 250;
    double torque = 0;
    const int steps = 10000;
    const double width = (cell.outer_radius - cell.inner_radius) / steps;
    for (int i = 0; i < steps; ++i) {
        const double radius = cell.inner_radius + (i + 0.5) * width;
        torque += 2 * std::numbers::pi * radius * radius * stress * width;
    }
    EXPECT_NEAR(shear_stress(torque, cell), stress, 1e-6 * stress);
}

TEST(AnnularCell, DoublesTheShearStressInThePrintedForm) {
    AnnularCell printed = cell;
    printed.torque_formula = FormulaVariant::as_printed;
    EXPECT_DOUBLE_EQ(shear_stress(0.01, printed), 2 * shear_stress(0.01, cell));
}

TEST(AnnularCell, ConvertsForceHeightAndSpeed) {
    const double area = std::numbers::pi * (0.045 * 0.045 - 0.021 * 0.021);
    EXPECT_NEAR(normal_stress(5, cell), 5 / area, 1e-9);
    EXPECT_NEAR(solid_fraction(0.02, cell), 5.7e-5 / (0.02 * area), 1e-12);
    EXPECT_NEAR(shear_rate(2, 0.02, cell), 2 * 0.033 / 0.02, 1e-12);
}

TEST(AnnularCell, ShowsWhatItsConversionsReadBack) {
    for (const FormulaVariant form : {FormulaVariant::derived, FormulaVariant::as_printed}) {
        AnnularCell either = cell;
        either.torque_formula = form;
        EXPECT_NEAR(shear_stress(torque(250, either), either), 250, 1e-10);
    }
    EXPECT_NEAR(normal_stress(normal_force(800, cell), cell), 800, 1e-10);
    EXPECT_NEAR(solid_fraction(height(0.6, cell), cell), 0.6, 1e-14);
    EXPECT_NEAR(shear_rate(angular_velocity(7, 0.02, cell), 0.02, cell), 7, 1e-12);
}

TEST(AnnularCell, PropagatesCovarianceByTheConversionsDerivatives) {
    // Against central differences of the conversions themselves.
    const double torque = 0.03, height = 0.02;
    Eigen::Matrix2d raw;
    raw << 4e-8, -3e-9, -3e-9, 1e-9;
    const double dt = 1e-6, dh = 1e-7;
    Eigen::Matrix2d jacobian = Eigen::Matrix2d::Zero();
    jacobian(0, 0) = (shear_stress(torque + dt, cell) - shear_stress(torque - dt, cell)) / (2 * dt);
    jacobian(1, 1) =
        (solid_fraction(height + dh, cell) - solid_fraction(height - dh, cell)) / (2 * dh);
    const Eigen::Matrix2d expected = jacobian * raw * jacobian.transpose();
    const Eigen::Matrix2d found = covariance_of_reading(height, raw, cell);
    EXPECT_LT((found - expected).norm(), 1e-6 * expected.norm());
    EXPECT_GT(found(0, 1), 0);  // a higher gap is a lower solid fraction
}

TEST(GrainProperties, GiveMassInertialAndStiffnessNumber) {
    const GrainProperties grains{.diameter = 500e-6, .density = 1050, .youngs_modulus = 3.3e9};
    EXPECT_NEAR(grains.mass(), 1050 * std::numbers::pi * std::pow(500e-6, 3) / 6, 1e-18);
    // The other convention, rate a sqrt(rho/s22), is sqrt(6/pi) = 1.382 times larger.
    const double other = 2 * 500e-6 * std::sqrt(1050 / 1000.0);
    EXPECT_NEAR(other / inertial_number(2, 1000, grains), 1.382, 5e-4);
    EXPECT_NEAR(inertial_number(shear_rate_at(0.01, 700, grains), 700, grains), 0.01, 1e-15);
    // Polystyrene at 0.3 and 3 kPa: 53,000 and 11,000.
    EXPECT_NEAR(*stiffness_number(300, grains), 53000, 1000);
    EXPECT_NEAR(*stiffness_number(3000, grains), 11000, 500);
    EXPECT_EQ(stiffness_number(300, GrainProperties{}), std::nullopt);
}

TEST(GrainProperties, GivePullOffForceAndReducedPressure) {
    const GrainProperties grains{.diameter = 500e-6, .density = 1050};
    constexpr double degree = std::numbers::pi / 180;
    // Badetti et al.'s system, polystyrene and silicone oil at a contact angle of 2 to 5 degrees:
    // P* = 1 is 0.129 kPa as printed, three digits.
    for (const double angle : {2 * degree, 5 * degree}) {
        const Liquid oil{.surface_tension = 20.6e-3, .contact_angle = angle};
        EXPECT_NEAR(1 / reduced_pressure(1, grains, oil), 129, 0.5);
    }
    // pi 500 um 20.6 mN/m = 32.36 uN for a liquid that wets perfectly, half of it at 60 degrees.
    const Liquid wetting{.surface_tension = 20.6e-3};
    const Liquid reluctant{.surface_tension = 20.6e-3, .contact_angle = 60 * degree};
    EXPECT_NEAR(pull_off_force(grains, wetting), 32.36e-6, 0.005e-6);
    EXPECT_NEAR(pull_off_force(grains, reluctant) / pull_off_force(grains, wetting), 0.5, 1e-12);
    // P* = a s22/(pi Gamma): beads half as large under twice the stress are as cohesive.
    const GrainProperties small{.diameter = 250e-6, .density = 1050};
    EXPECT_NEAR(reduced_pressure(600, small, wetting), reduced_pressure(300, grains, wetting),
                1e-12);
    // 0.3 kPa is Badetti et al.'s lowest fitted P* of 2.3.
    EXPECT_NEAR(reduced_pressure(300, grains, wetting), 2.32, 0.005);
}

}  // namespace pendular::data_annular_cell_test
