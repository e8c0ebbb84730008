// Fits of frictions near the end of the simulated range (0.6), where the errors of the emulator
// change most with the friction: unbiased, and the same from every start.
#include <gtest/gtest.h>

#include <cmath>

#include "calib/fit/fit.h"
#include "tests/physics/planted_readings.h"

namespace edge_of_atlas_test {

using namespace pendular;

const Model& bare_model() {
    static const std::shared_ptr<const Model> model = models().with({});
    return *model;
}

/// Readings whose truth is off the emulator as its own errors allow.
Measured readings_at(double friction, std::mt19937_64& random) {
    const Prediction exact = bare_model().predict(Eigen::VectorXd::Constant(1, friction));
    Eigen::MatrixXd covariance = exact.covariance;
    covariance.diagonal() *= 1 + 1e-6;  // some readings are predicted alike
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd lower = covariance.llt().matrixL();
    const Eigen::VectorXd values =
        exact.value +
        lower * Eigen::VectorXd::NullaryExpr(lower.rows(), [&] { return normal(random); });
    return stack(scattered(conditions(), values, random));
}

Fit fitted_from(double start, const Measured& measured) {
    return fit(bare_model(), measured, Eigen::VectorXd::Constant(1, start));
}

// 200 fits for each friction: the mean error is 0 within 3.9/sqrt(200) = 0.28 of the stated error
// (one chance in 10,000), the scatter is the stated error within 4/sqrt(2 * 200) = 20 %.
TEST(EdgeOfAtlas, FrictionsAreFittedWithoutBias) {
    std::mt19937_64 random(11);
    for (const double truth : {0.09, 0.45, 0.52, 0.56}) {
        double sum = 0, squares = 0;
        constexpr int count = 200;
        for (int k = 0; k < count; ++k) {
            const Fit fit = fitted_from(0.15, readings_at(truth, random));
            const double error = (fit.parameters(0) - truth) / fit.standard_error(0);
            sum += error, squares += error * error;
        }
        EXPECT_NEAR(sum / count, 0, 3.9 / std::sqrt(count)) << truth;
        EXPECT_NEAR(std::sqrt(squares / count), 1, 4 / std::sqrt(2 * count)) << truth;
    }
}

TEST(EdgeOfAtlas, TheFitDoesNotDependOnItsStart) {
    std::mt19937_64 random(12);
    for (const double truth : {0.05, 0.3, 0.45, 0.56}) {
        for (int k = 0; k < 10; ++k) {
            Measured measured = readings_at(truth, random);
            // A misfit, with which weights matter most: torques 10 % too large.
            if (k % 2 == 1) measured.value(Eigen::seq(0, Eigen::last, 2)) *= 1.1;
            const Fit low = fitted_from(0.02, measured), high = fitted_from(0.58, measured);
            EXPECT_NEAR(low.parameters(0), high.parameters(0), 0.01 * low.standard_error(0))
                << truth << ", " << k;
        }
    }
}

}  // namespace edge_of_atlas_test
