// Fits whose simulation errors depend on the parameters, as they do near the end of the simulated
// range: the result depends on no start, and is unbiased.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "calib/fit/fit.h"

namespace calib_fit_weights_test {

using namespace pendular;

/// f_k = x_k theta with a simulation error, common to all values, that grows steeply towards the
/// upper end of the range, and one of each value.
class WorseAtTheEdge : public Model {
  public:
    explicit WorseAtTheEdge(Eigen::Index values)
        : x_(Eigen::VectorXd::LinSpaced(values, 0.5, 1.5)) {}

    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& p, PredictionPart /*what*/) const override {
        const double error = 0.002 * std::exp(8 * (p(0) - 0.3));
        const Eigen::VectorXd common = error * x_.cwiseAbs2();
        const Eigen::MatrixXd covariance =
            common * common.transpose() + Eigen::MatrixXd((error * x_).cwiseAbs2().asDiagonal());
        return {x_ * p(0), x_, covariance, covariance};
    }
    ParameterBounds bounds() const override {
        return {Eigen::VectorXd::Constant(1, 0.0), Eigen::VectorXd::Constant(1, 0.6)};
    }
    /// Values with the errors of measurement and simulation.
    Measured measured(double truth, std::mt19937_64& random) const {
        const Prediction exact = predict(Eigen::VectorXd::Constant(1, truth), {});
        const Eigen::MatrixXd own = 1e-4 * Eigen::MatrixXd::Identity(x_.size(), x_.size());
        std::normal_distribution<double> normal;
        const Eigen::LLT<Eigen::MatrixXd> root(exact.covariance + own);
        const Eigen::VectorXd errors =
            Eigen::VectorXd::NullaryExpr(x_.size(), [&] { return normal(random); });
        return {exact.value + root.matrixL() * errors, own};
    }

  private:
    Eigen::VectorXd x_;
    std::vector<Parameter> parameters_ = {
        {.name = "friction", .lower = 0, .upper = 1, .start = 0.1}};
};

Fit fit_from(const Model& model, const Measured& measured, double start) {
    return fit(model, measured, Eigen::VectorXd::Constant(1, start));
}

TEST(FitWeights, AreThoseOfTheResultWhateverTheStart) {
    const WorseAtTheEdge model(24);
    std::mt19937_64 random(3);
    for (const double truth : {0.2, 0.4, 0.5}) {
        const Measured measured = model.measured(truth, random);
        const Fit low = fit_from(model, measured, 0.02), high = fit_from(model, measured, 0.59);
        EXPECT_NEAR(low.parameters(0), high.parameters(0), 0.03 * low.standard_error(0)) << truth;
        EXPECT_NEAR(low.chi2, high.chi2, 0.01 * low.chi2) << truth;
        // chi2 is that with the weights of the result.
        const Eigen::MatrixXd covariance = measured.covariance + low.prediction.covariance;
        const Eigen::VectorXd misfit = measured.value - low.prediction.value;
        EXPECT_NEAR(low.chi2, misfit.dot(covariance.ldlt().solve(misfit)), 1e-6 * low.chi2);
    }
}

/// f = (theta, theta), whose simulation errors move the weight to the value 0 as theta rises,
/// so strongly that fits with the weights of the result before alternate between two values: at a
/// steepness of 4 between 0.02 and 0.98.
class Alternating : public Model {
  public:
    explicit Alternating(double steepness) : steepness_(steepness) {}
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& p, PredictionPart /*what*/) const override {
        const double steep = steepness_ * (p(0) - 0.5);
        const Eigen::MatrixXd covariance =
            Eigen::Vector2d(std::exp(steep), std::exp(-steep)).asDiagonal();
        return {Eigen::Vector2d::Constant(p(0)), Eigen::Vector2d::Ones(), covariance, covariance};
    }
    ParameterBounds bounds() const override {
        return {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1)};
    }

  private:
    double steepness_;
    std::vector<Parameter> parameters_ = {
        {.name = "friction", .lower = 0, .upper = 1, .start = 0.1}};
};

TEST(FitWeights, SettleBetweenTwoResultsThatTakeTurns) {
    // By symmetry the fit with the weights of its own result is 0.5.
    const Measured measured{Eigen::Vector2d(1, 0), 1e-9 * Eigen::Matrix2d::Identity()};
    const Fit result = fit_from(Alternating(2.4), measured, 0.1);
    EXPECT_TRUE(result.converged) << result.message;
    EXPECT_NEAR(result.parameters(0), 0.5, 1e-3);
}

TEST(FitWeights, AreNotCalledConvergedWhereTheyDoNotSettle) {
    const Measured measured{Eigen::Vector2d(1, 0), 1e-9 * Eigen::Matrix2d::Identity()};
    const Fit result = fit_from(Alternating(4), measured, 0.1);
    EXPECT_FALSE(result.converged);
    EXPECT_NE(result.message.find("do not settle"), std::string::npos) << result.message;
}

// The mean error of 400 fits is 0 within 3.9 of its standard errors (one chance in 10,000), and the
// scatter is the stated error within 4 times 1/sqrt(2 * 400) = 14 %. Minimising chi2 with
// Sigma(theta) instead would be drawn to the edge: its chi2 falls where Sigma grows.
TEST(FitWeights, LeaveTheFitUnbiasedAtTheEdgeOfTheSimulations) {
    const WorseAtTheEdge model(24);
    std::mt19937_64 random(4);
    for (const double truth : {0.25, 0.4, 0.5}) {
        double sum = 0, squares = 0;
        constexpr int count = 400;
        for (int k = 0; k < count; ++k) {
            const Fit fit = fit_from(model, model.measured(truth, random), 0.1);
            const double error = (fit.parameters(0) - truth) / fit.standard_error(0);
            sum += error, squares += error * error;
        }
        EXPECT_NEAR(sum / count, 0, 3.9 / std::sqrt(count)) << truth;
        EXPECT_NEAR(std::sqrt(squares / count), 1, 0.14) << truth;
    }
}

}  // namespace calib_fit_weights_test
