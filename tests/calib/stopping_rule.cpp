// When more simulation is not worth its time: by how much the noise of the runs enlarges errors.
#include "calib/fit/stopping_rule.h"

#include <cmath>

#include "calib/fit/calibrate.h"
#include "tests/support/golden.h"

namespace pendular::calib_stopping_rule_test {

/// Fit of two parameters to two values, all errors of the size 1 but for the noise of runs.
Fit fitted(const Eigen::Vector2d& parameter_noise, const Eigen::Vector2d& reading_noise) {
    Fit fit;
    fit.parameters = Eigen::Vector2d(0.4, 0.2);
    fit.run_part = parameter_noise.asDiagonal();
    fit.covariance = Eigen::Matrix2d::Identity() + fit.run_part;
    fit.prediction.run_noise = reading_noise.asDiagonal();
    fit.prediction.covariance = fit.prediction.run_noise;
    return fit;
}

const Measured measured{Eigen::Vector2d(1, 1), Eigen::Matrix2d::Identity()};
const std::vector<Parameter> parameters = {{.name = "friction"}, {.name = "coefficient"}};

TEST(StoppingRule, IsAFifthOfAnError) {
    // 1.2^2 = 1.44: the noise may have 0.44 of the variance of all other errors.
    EXPECT_NEAR(enlargement(0.44, 1), 0.2, 1e-12);
    EXPECT_NEAR(Enlargement{0.2}.excess(), 1, 1e-12);
    EXPECT_NEAR(Enlargement{enlargement(0.88, 1)}.excess(), 2, 1e-12);
    EXPECT_EQ(enlargement(0, 0), 0);
    EXPECT_GT(Enlargement{enlargement(1, 0)}.excess(), 100);
}

TEST(StoppingRule, IsThatOfTheWorstParameterAndOfTheWorstPrediction) {
    const auto worst = [](const Eigen::Vector2d& of_parameters,
                          const Eigen::Vector2d& of_readings) {
        return enlargement_by_runs(fitted(of_parameters, of_readings), measured, parameters);
    };
    EXPECT_EQ(worst({0, 0}, {0, 0}).size, 0);
    const Enlargement parameter = worst({0.1, 0.6}, {0.2, 0.3});
    EXPECT_EQ(parameter.parameter, "coefficient");
    EXPECT_NEAR(parameter.size, std::sqrt(1.6) - 1, 1e-12);
    EXPECT_EQ(text_of(parameter), "the error of coefficient by 26 %");
    const Enlargement reading = worst({0.1, 0.2}, {0.3, 3});
    EXPECT_NEAR(reading.size, 1, 1e-12);
    EXPECT_EQ(text_of(reading), "the error of a predicted reading by 100 %");
}

/// Model whose prediction is known up to noise that rounds of runs do not reduce, with a time for
/// some rounds.
class NeverSure : public LearningModel, public Model {
  public:
    explicit NeverSure(int time) : time_(time) {}
    const Model& model() const override { return *this; }
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& p, PredictionPart /*what*/) const override {
        const Eigen::Matrix2d noise = 100 * Eigen::Matrix2d::Identity();
        return {Eigen::Vector2d(p(0), p(0)), Eigen::Vector2d(1, 1), noise, noise};
    }
    ParameterBounds bounds() const override {
        return {Eigen::VectorXd::Constant(1, -100), Eigen::VectorXd::Constant(1, 100)};
    }
    void improve(const Eigen::VectorXd& /*p*/, double /*excess*/) override { ++rounds; }
    bool exhausted() const override { return rounds >= time_; }
    int rounds = 0;

  private:
    int time_;
    std::vector<Parameter> parameters_ = {{.name = "theta", .lower = -100, .upper = 100}};
};

TEST(StoppingRule, GivesWayToTheEndOfTheTime) {
    NeverSure endless(1000), short_time(1);
    const Fit unsettled = calibrate(endless, measured, {});
    EXPECT_FALSE(unsettled.converged);
    EXPECT_EQ(endless.rounds, CalibrationOptions{}.most_rounds);
    // The noise has 100 times the variance of the readings: sqrt(101) - 1 = 9.05.
    expect_told({unsettled.message});
    EXPECT_TRUE(calibrate(short_time, measured, {}).converged);
    EXPECT_EQ(short_time.rounds, 1);
}

}  // namespace pendular::calib_stopping_rule_test
