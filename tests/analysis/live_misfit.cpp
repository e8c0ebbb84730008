// Leaving out a reading, and chi2 as parameters move, of fits that are known.
#include "analysis/misfit/live_misfit.h"

#include <gtest/gtest.h>

#include <cmath>

#include "calib/fit/fit.h"
#include "tests/support/known_flow.h"

namespace live_misfit_test {

using namespace pendular;

/// Four readings whose entries grow with the sum of `count` parameters.
class Sum : public Known<Model> {
  public:
    explicit Sum(std::size_t count)
        : Known<Model>(std::vector<Parameter>(count, {"x", "1", -10, 10, 0.1})) {}

    Prediction predict(const Eigen::VectorXd& parameters, PredictionPart) const override {
        const Eigen::VectorXd places = Eigen::VectorXd::LinSpaced(8, 1, 2);
        return {.value = parameters.sum() * places,
                .jacobian = places * Eigen::RowVectorXd::Ones(parameters.size()),
                .covariance = Eigen::MatrixXd::Zero(8, 8),
                .run_noise = Eigen::MatrixXd::Zero(8, 8)};
    }
};

Measured measured() {
    Measured all{Eigen::VectorXd(8), 0.01 * Eigen::MatrixXd::Identity(8, 8)};
    all.value << 1.1, 1.0, 1.4, 1.3, 1.7, 1.9, 1.8, 2.6;
    return all;
}

TEST(LeavingOutAReading, IsRefittingWithoutIt) {
    const Fit all = fit(Sum(1), measured(), Eigen::VectorXd::Constant(1, 0.1));
    const Eigen::MatrixXd without = without_each(measured(), all.prediction, 4);
    ASSERT_EQ(without.rows(), 4);
    for (Eigen::Index k = 0; k < 4; ++k) {
        Measured rest = measured();  // without the two entries of the reading
        rest.covariance.diagonal().segment<2>(2 * k).setConstant(1e12);
        const Fit refitted = fit(Sum(1), rest, all.parameters);
        EXPECT_NEAR(without(k, 0), all.chi2 - refitted.chi2, 1e-6);
        EXPECT_NEAR(without(k, 1), refitted.parameters(0) - all.parameters(0), 1e-8);
    }
}

TEST(LeavingOutAReading, NeedsNoParameterToBeDetermined) {
    const Fit one = fit(Sum(1), measured(), Eigen::VectorXd::Constant(1, 0.1));
    const Fit two = fit(Sum(2), measured(), Eigen::VectorXd::Constant(2, 0.1));
    const Eigen::MatrixXd of_one = without_each(measured(), one.prediction, 4),
                          of_two = without_each(measured(), two.prediction, 4);
    for (Eigen::Index k = 0; k < 4; ++k) {
        EXPECT_NEAR(of_two(k, 0), of_one(k, 0), 1e-4 * of_one(k, 0));
        EXPECT_NEAR(of_two(k, 1) + of_two(k, 2), of_one(k, 1), 1e-4);
    }
}

}  // namespace live_misfit_test
