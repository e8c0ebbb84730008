// The size of a model's smooth error, from residuals that are drawn with it.
#include "analysis/diagnosis/likely_discrepancy.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <random>

#include "calib/model/discrepancy.h"

namespace analysis_likely_discrepancy_test {

using namespace pendular;

class LikelyDiscrepancy : public testing::Test {
  protected:
    LikelyDiscrepancy() {
        for (const double stress : {200.0, 400.0, 800.0, 1600.0, 3200.0}) {
            for (const double number : {0.001, 0.003, 0.01, 0.03}) {
                for (int replicate = 0; replicate < 2; ++replicate) {
                    Reading reading;
                    reading.condition = {.normal_stress = stress, .inertial_number = number};
                    reading.value = {0.3 * stress, 0.6};
                    reading.covariance =
                        Eigen::Vector2d(0.003 * 0.3 * stress, 0.001).cwiseAbs2().asDiagonal();
                    readings_.push_back(reading);
                }
            }
        }
    }

    /// Estimate from readings whose model is off by a smooth error of this relative size.
    double estimate(double size) {
        Measured measured = stack(readings_);
        const Eigen::MatrixXd covariance =
            measured.covariance +
            discrepancy_covariance(conditions_of(readings_), measured.value, {size, 0});
        const Eigen::MatrixXd root = Eigen::LLT<Eigen::MatrixXd>(covariance).matrixL();
        const Eigen::VectorXd noise =
            Eigen::VectorXd::NullaryExpr(measured.value.size(), [&] { return normal_(random_); });
        const Prediction prediction{
            measured.value,
            measured.value,  // a factor on all values is fitted
            Eigen::MatrixXd::Zero(measured.value.size(), measured.value.size()),
            {}};
        measured.value += root * noise;
        return likely_discrepancy(measured, prediction, conditions_of(readings_));
    }

    std::vector<Reading> readings_;
    std::mt19937_64 random_{5};
    std::normal_distribution<double> normal_;
};

TEST_F(LikelyDiscrepancy, IsFoundWithinAFactorOfTwo) {
    std::vector<double> found;
    for (int study = 0; study < 40; ++study)
        found.push_back(estimate(0.01));
    std::ranges::sort(found);
    EXPECT_GT(found[20], 0.005);
    EXPECT_LT(found[20], 0.02);
    EXPECT_GT(found[4], 0);  // seen in nine of ten
}

TEST_F(LikelyDiscrepancy, IsZeroForAnExactModelBut5In100) {
    int seen = 0;
    for (int study = 0; study < 100; ++study)
        seen += estimate(0) > 0;
    EXPECT_LE(seen, 12);  // 5 expected; 12 or more by chance in 1 of 250
}

}  // namespace analysis_likely_discrepancy_test
