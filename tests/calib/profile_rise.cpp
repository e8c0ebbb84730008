// Profile likelihood of a model that is linear in its parameters: a parabola.
#include "calib/fit/parameter_errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pendular::calib_profile_rise_test {

/// Values a + b x at x = 0, 1, ..., 5.
class Line : public Model {
  public:
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& p, PredictionPart) const override {
        Prediction result{.value = Eigen::VectorXd(6),
                          .jacobian = Eigen::MatrixXd(6, 2),
                          .covariance = Eigen::MatrixXd::Zero(6, 6),
                          .run_noise = Eigen::MatrixXd::Zero(6, 6)};
        for (int k = 0; k < 6; ++k) {
            result.value(k) = p(0) + p(1) * k;
            result.jacobian.row(k) << 1, k;
        }
        return result;
    }
    ParameterBounds bounds() const override {
        return {Eigen::Vector2d(-10, -10), Eigen::Vector2d(10, 10)};
    }

  private:
    std::vector<Parameter> parameters_{{.name = "a", .lower = -10, .upper = 10},
                                       {.name = "b", .lower = -10, .upper = 10}};
};

TEST(ProfileRise, IsTheParabolaOfTheStandardErrorForALinearModel) {
    Measured measured{Eigen::VectorXd(6), 0.04 * Eigen::MatrixXd::Identity(6, 6)};
    measured.value << 1.1, 1.9, 3.2, 3.8, 5.1, 6.0;
    const Line line;
    const Fit best = fit(line, measured, Eigen::Vector2d(0, 0));
    for (const Eigen::Index which : {0, 1}) {
        const double error = best.standard_error(which);
        const Eigen::Vector3d values = best.parameters(which) + error * Eigen::Array3d(-2, 0, 1.5);
        const Eigen::VectorXd rises = profile_rise(line, measured, best, which, values);
        EXPECT_NEAR(rises(0), 4, 1e-6);
        EXPECT_NEAR(rises(1), 0, 1e-6);
        EXPECT_NEAR(rises(2), 2.25, 1e-6);
    }
}

}  // namespace pendular::calib_profile_rise_test
