// The expected error of a model, stated by a study, in the covariance of its predictions.
#include "calib/model/discrepancy.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "tests/physics/planted_readings.h"

namespace calib_discrepancy_test {

using namespace pendular;

Condition condition(double normal_stress, double liquid_content) {
    return {
        .normal_stress = normal_stress, .inertial_number = 0.01, .liquid_content = liquid_content};
}

TEST(Discrepancy, IsHalfSmoothOverADecadeOfStressAndHalfOfEachCondition) {
    EXPECT_EQ(discrepancy_correlation(condition(300, 0), condition(300, 0)), 1);
    EXPECT_NEAR(discrepancy_correlation(condition(300, 0), condition(3000, 0)), std::exp(-0.5) / 2,
                1e-12);
    EXPECT_GT(discrepancy_correlation(condition(300, 0), condition(309, 0)), 0.98);  // replicates
    EXPECT_LT(discrepancy_correlation(condition(300, 0), condition(300, 0.03)), 0.5);
}

TEST(Discrepancy, IsRelativeToThePredictedValues) {
    const std::vector<Condition> two = {condition(300, 0), condition(3000, 0)};
    const Eigen::VectorXd values = Eigen::Vector4d(90, 0.6, 900, 0.61);
    const Eigen::MatrixXd covariance = discrepancy_covariance(two, values, {0.005, 0.001});
    EXPECT_NEAR(covariance(0, 0), std::pow(0.005 * 90, 2), 1e-12);
    EXPECT_NEAR(covariance(0, 2), 0.005 * 0.005 * std::exp(-0.5) / 2 * 90 * 900, 1e-9);
    EXPECT_NEAR(covariance(3, 3), std::pow(0.001 * 0.61, 2), 1e-15);
    EXPECT_EQ(covariance(0, 1), 0);
    EXPECT_TRUE(covariance.isApprox(covariance.transpose()));
}

TEST(Discrepancy, IsInTheErrorsOfAStudysPredictions) {
    Study inexact = planted_study();
    inexact.model.discrepancy = {0.005, 0.001};
    const Eigen::VectorXd friction = Eigen::VectorXd::Constant(1, planted_friction);
    const auto exact = models().with({})->predict(friction);
    const auto stated = models_of(conditions(), inexact).with({})->predict(friction);
    EXPECT_EQ(stated.value, exact.value);
    EXPECT_EQ(stated.run_noise, exact.run_noise);
    EXPECT_TRUE(stated.covariance.isApprox(
        exact.covariance + discrepancy_covariance(conditions(), exact.value, {0.005, 0.001})));
}

}  // namespace calib_discrepancy_test
