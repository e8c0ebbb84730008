// The fitter on models whose answer is known in closed form.
#include <fmt/format.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "calib/fit/calibrate.h"
#include "calib/fit/calibration_notes.h"
#include "calib/fit/parameter_errors.h"
#include "tests/support/golden.h"

namespace calib_fit_test {

using namespace pendular;

/// f = A theta + b with a covariance of its own: generalised least squares has a closed answer.
class Linear : public Model {
  public:
    Eigen::MatrixXd matrix;
    Eigen::VectorXd offset;
    Eigen::MatrixXd noise;
    std::vector<Parameter> names;

    Linear(Eigen::Index readings, Eigen::Index count, unsigned seed) {
        std::srand(seed);
        matrix = Eigen::MatrixXd::Random(2 * readings, count);
        offset = Eigen::VectorXd::Random(2 * readings);
        const Eigen::MatrixXd root = 0.05 * Eigen::MatrixXd::Random(2 * readings, 2 * readings);
        noise = root * root.transpose();
        for (Eigen::Index k = 0; k < count; ++k) {
            names.push_back(
                {.name = fmt::format("p{}", k), .lower = -10, .upper = 10, .start = 0.1});
        }
    }
    const std::vector<Parameter>& parameters() const override { return names; }
    Prediction predict(const Eigen::VectorXd& p, PredictionPart /*what*/) const override {
        return {matrix * p + offset, matrix, noise, noise};
    }
    ParameterBounds bounds() const override {
        const auto n = static_cast<Eigen::Index>(names.size());
        return {Eigen::VectorXd::Constant(n, -100), Eigen::VectorXd::Constant(n, 100)};
    }
};

Measured some_readings(const Linear& model, unsigned seed) {
    std::srand(seed);
    const auto n = model.matrix.rows();
    const Eigen::MatrixXd root = 0.2 * Eigen::MatrixXd::Random(n, n);
    return {Eigen::VectorXd::Random(n),
            root * root.transpose() + 0.01 * Eigen::MatrixXd::Identity(n, n)};
}

TEST(Fit, NamesWhatTheReadingsDoNotTellApart) {
    Linear model(6, 3, 1);
    model.matrix.col(2) = -2 * model.matrix.col(1);
    model.names[2].unit = "mN";
    const Fit result = fit(model, some_readings(model, 2), Eigen::VectorXd::Constant(3, 0.1));
    const auto sentences = undetermined(result, model.names);
    pendular::expect_told(sentences);
    const Linear determined(6, 3, 1);
    EXPECT_TRUE(undetermined(fit(determined, some_readings(determined, 2),
                                 Eigen::VectorXd::Constant(3, 0.1)),
                             determined.names)
                    .empty());
}

TEST(Fit, DeterminesWhatNoSentenceNames) {
    // The range is that of the simulations, and few replicates enlarge the error.
    const std::vector<Parameter> friction = {{.name = "friction", .upper = 1}};
    Fit fit{.parameters = Eigen::VectorXd::Constant(1, 0.1),
            .covariance = Eigen::MatrixXd::Constant(1, 1, 0.04),
            .range = {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Constant(1, 0.3)}};
    EXPECT_TRUE(fit.determines(0));
    EXPECT_TRUE(undetermined(fit, friction).empty());
    fit.widening = Eigen::MatrixXd::Constant(1, 1, 0.06);
    EXPECT_FALSE(fit.determines(0));
    EXPECT_EQ(undetermined(fit, friction).size(), 1u);
}

TEST(Fit, IsGeneralisedLeastSquares) {
    const Linear model(6, 3, 1);
    const Measured measured = some_readings(model, 2);
    const Fit result = fit(model, measured, Eigen::VectorXd::Zero(3));
    const Eigen::MatrixXd weight = (measured.covariance + model.noise).inverse();
    const Eigen::MatrixXd covariance = (model.matrix.transpose() * weight * model.matrix).inverse();
    const Eigen::VectorXd best =
        covariance * model.matrix.transpose() * weight * (measured.value - model.offset);
    const Eigen::VectorXd left = measured.value - model.offset - model.matrix * best;
    EXPECT_TRUE(result.converged) << result.message;
    EXPECT_LT((result.parameters - best).norm(), 1e-7);
    EXPECT_LT((result.covariance - covariance).norm(), 1e-7 * covariance.norm());
    EXPECT_NEAR(result.chi2, left.dot(weight * left), 1e-7 * result.chi2);
    EXPECT_EQ(result.dof, 9);
}

TEST(Fit, SplitsItsErrorIntoMeasurementAndSimulation) {
    const Linear model(6, 2, 3);
    const Measured measured = some_readings(model, 4);
    const Fit result = fit(model, measured, Eigen::VectorXd::Zero(2));
    const Eigen::MatrixXd weight = (measured.covariance + model.noise).inverse();
    const Eigen::MatrixXd estimator = result.covariance * model.matrix.transpose() * weight;
    for (Eigen::Index k = 0; k < 2; ++k) {
        EXPECT_NEAR(std::pow(result.measurement_error(k), 2),
                    (estimator * measured.covariance * estimator.transpose())(k, k), 1e-9);
        EXPECT_NEAR(std::pow(result.simulation_error(k), 2),
                    (estimator * model.noise * estimator.transpose())(k, k), 1e-9);
    }
}

TEST(Fit, SaysWhenTheReadingsDoNotDetermineAParameter) {
    Linear model(6, 2, 9);
    model.matrix.col(1).setZero();
    const Fit result = fit(model, some_readings(model, 10), Eigen::VectorXd::Zero(2));
    EXPECT_FALSE(result.converged);
    EXPECT_EQ(result.message, "the readings do not determine p1");
}

TEST(Fit, SaysWhenAParameterEndsAtItsBound) {
    Linear model(6, 1, 5);
    const Measured measured = some_readings(model, 6);
    const double free = fit(model, measured, Eigen::VectorXd::Zero(1)).parameters(0);
    EXPECT_FALSE(fit(model, measured, Eigen::VectorXd::Zero(1)).at_bound[0]);
    model.names[0].lower = free + 0.5;
    const Fit bounded = fit(model, measured, Eigen::VectorXd::Zero(1));
    EXPECT_TRUE(bounded.at_bound[0]);
    EXPECT_TRUE(bounded.converged);
    EXPECT_NEAR(bounded.parameters(0), free + 0.5, 1e-9);
}

TEST(Fit, RefinesTheOthersWhereAParameterIsAtItsBound) {
    Linear model(6, 2, 5);
    const Measured measured = some_readings(model, 6);
    const Eigen::VectorXd free = fit(model, measured, Eigen::VectorXd::Zero(2)).parameters;
    model.names[0].lower = free(0) + 0.5;
    const Eigen::Vector2d start(free(0) + 0.5, free(1) + 1);
    // Without a step of Ceres, so that the refinement has to find the minimum.
    const Fit refined = fit(model, measured, start, {.most_steps = 0, .elsewhere = false});
    EXPECT_TRUE(refined.converged);
    EXPECT_TRUE(refined.at_bound[0]);
    const Fit searched = fit(model, measured, start);
    EXPECT_NEAR(refined.parameters(1), searched.parameters(1), 1e-6);
    EXPECT_NEAR(refined.chi2, searched.chi2, 1e-9 * searched.chi2);
}

TEST(Profile, IsTheStandardErrorWhereTheModelIsLinear) {
    for (const Eigen::Index count : {1, 3}) {
        const Linear model(6, count, 7);
        const Measured measured = some_readings(model, 8);
        const Fit best = fit(model, measured, Eigen::VectorXd::Zero(count));
        const auto [low, high] = profile_interval(model, measured, best, 0);
        EXPECT_NEAR(best.parameters(0) - low, best.standard_error(0),
                    1e-4 * best.standard_error(0));
        EXPECT_NEAR(high - best.parameters(0), best.standard_error(0),
                    1e-4 * best.standard_error(0));
    }
}

/// A stand-in for simulations: y = (theta^2, 1 - theta) at a few places plus noise, seen through a
/// parabola fitted to what was "run" so far. It differs from the real model in cost only.
class NoisyModel : public LearningModel, public Model {
  public:
    NoisyModel(unsigned seed, double noise) : random_(seed), noise_(noise) {}

    const Model& model() const override { return *this; }
    const std::vector<Parameter>& parameters() const override { return names_; }
    Prediction predict(const Eigen::VectorXd& p, PredictionPart /*what*/) const override {
        const Eigen::Matrix3d inverse = (design().transpose() * design()).inverse();
        const Eigen::RowVector3d row(1, p(0), p(0) * p(0)), slope(0, 1, 2 * p(0));
        Prediction prediction{
            Eigen::VectorXd(2), Eigen::MatrixXd(2, 1), Eigen::MatrixXd::Zero(2, 2), {}};
        for (Eigen::Index o = 0; o < 2; ++o) {
            const Eigen::Vector3d c =
                inverse * design().transpose() *
                Eigen::Map<const Eigen::VectorXd>(y_[static_cast<std::size_t>(o)].data(),
                                                  static_cast<Eigen::Index>(x_.size()));
            prediction.value(o) = row.dot(c);
            prediction.jacobian(o, 0) = slope.dot(c);
            prediction.covariance(o, o) = noise_ * noise_ * row.dot(inverse * row.transpose());
        }
        prediction.run_noise = prediction.covariance;
        return prediction;
    }
    void improve(const Eigen::VectorXd& p, double) override {
        ++rounds;
        const double width = x_.empty() ? 0.5 : 0.15;
        for (const double x : {p(0) - width, p(0), p(0) + width}) {
            x_.push_back(x);
            y_[0].push_back(x * x + noise_ * normal_(random_));
            y_[1].push_back(1 - x + noise_ * normal_(random_));
        }
    }
    ParameterBounds bounds() const override {
        return {Eigen::VectorXd::Constant(1, *std::ranges::min_element(x_)),
                Eigen::VectorXd::Constant(1, *std::ranges::max_element(x_))};
    }
    int rounds = 0;

  private:
    Eigen::MatrixXd design() const {
        Eigen::MatrixXd d(static_cast<Eigen::Index>(x_.size()), 3);
        for (std::size_t k = 0; k < x_.size(); ++k) {
            d.row(static_cast<Eigen::Index>(k)) << 1, x_[k], x_[k] * x_[k];
        }
        return d;
    }
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
    double noise_;
    std::vector<double> x_, y_[2];
    std::vector<Parameter> names_ = {{.name = "theta", .lower = 0, .upper = 2, .start = 0.6}};
};

TEST(Calibrate, ReportsTheErrorItReallyMakesOnANoisySimulator) {
    // 400 studies with fixed seeds. The variance of (answer - truth)/error has a standard error of
    // sqrt(2/400) = 0.07; 0.78 to 1.25 is 3 of them and a half. A fit stalled by noise, or one that
    // takes the noise for signal, ends far outside.
    double sum = 0, mean = 0;
    const int studies = 400;
    for (unsigned study = 0; study < studies; ++study) {
        std::mt19937_64 random(1000 + study);
        std::normal_distribution<double> normal;
        const double truth = 0.3 + 0.8 * study / studies;
        Measured measured{Eigen::Vector2d(truth * truth, 1 - truth),
                          Eigen::Matrix2d::Identity() * 4e-4};
        measured.value += 0.02 * Eigen::Vector2d(normal(random), normal(random));
        NoisyModel model(study, 0.03);
        const Fit result = calibrate(model, measured, {});
        ASSERT_TRUE(result.converged);
        const double z = (result.parameters(0) - truth) / result.standard_error(0);
        sum += z * z / studies;
        mean += z / studies;
        // All of the model's errors are noise of its runs, which may enlarge the error by a fifth.
        EXPECT_LE(result.standard_error(0), 1.2 * result.measurement_error(0) + 1e-9);
    }
    EXPECT_GT(sum, 0.78);
    EXPECT_LT(sum, 1.25);
    EXPECT_NEAR(mean, 0, 3.5 / std::sqrt(studies));
}

TEST(Calibrate, AsksForMoreSimulationWhereTheReadingsAreSharper) {
    const auto rounds = [](double error) {
        NoisyModel model(1, 0.03);
        calibrate(model, {Eigen::Vector2d(0.49, 0.3), Eigen::Matrix2d::Identity() * error * error},
                  {});
        return model.rounds;
    };
    EXPECT_GT(rounds(0.008), rounds(0.1));
}

TEST(Calibrate, SaysWhenItDidNotConverge) {
    NoisyModel model(1, 0.5);  // hopelessly noisy for these readings
    const Fit result =
        calibrate(model, {Eigen::Vector2d(0.49, 0.3), Eigen::Matrix2d::Identity() * 1e-8}, {});
    EXPECT_FALSE(result.converged);
    EXPECT_FALSE(result.message.empty());
}

}  // namespace calib_fit_test
