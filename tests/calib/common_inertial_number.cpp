// Readings at constant speed, brought to one inertial number by a model whose law is known.

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/predicted_readings.h"
#include "tests/support/golden.h"

namespace calib_common_inertial_number_test {

using namespace pendular;

const GrainProperties grains{.diameter = 300e-6, .density = 2500};
const Liquid water{.surface_tension = 72e-3};
const double unit = pull_off_force(grains, water) / (grains.diameter * grains.diameter);  // [Pa]

constexpr double friction = 0.3, cohesion = 0.35, by_rate = 0.8, packing_by_rate = 0.2;
constexpr double rate_error = 0.1;  ///< standard error of `by_rate`, which all readings share

/// mu* = mu + c*/P* + b sqrt(I), Phi = 0.6 - d sqrt(I), with an error of b.
class RateLaw : public Predictor {
  public:
    const std::vector<Parameter>& parameters() const override { return parameters_; }
    Prediction predict(const Eigen::VectorXd& p, const std::vector<Condition>& conditions,
                       PredictionPart /*what*/) const override {
        const auto n = 2 * std::ssize(conditions);
        Prediction result{Eigen::VectorXd(n), Eigen::MatrixXd::Zero(n, 1), {}, {}};
        Eigen::VectorXd common = Eigen::VectorXd::Zero(n);
        for (Eigen::Index k = 0; k < n; k += 2) {
            const Condition& c = conditions[static_cast<std::size_t>(k / 2)];
            const double root = std::sqrt(c.inertial_number);
            const double inverse = c.dry() ? 0 : unit / c.normal_stress;
            result.value(k) = c.normal_stress * (p(0) + cohesion * inverse + by_rate * root);
            result.value(k + 1) = 0.6 - packing_by_rate * root;
            result.jacobian(k, 0) = c.normal_stress;
            common(k) = c.normal_stress * rate_error * root;
        }
        result.covariance = result.run_noise = common * common.transpose();
        return result;
    }
    ParameterBounds bounds() const override {
        return {Eigen::VectorXd::Zero(1), Eigen::VectorXd::Ones(1)};
    }

  private:
    std::vector<Parameter> parameters_ = {{.name = "friction", .upper = 1, .start = 0.3}};
};

/// Wet readings at two speeds: I is proportional to speed/sqrt(normal stress). With `random`, the
/// stress ratios scatter by 0.005, and b is wrong by its error `of_rate`.
std::vector<Reading> at_constant_speed(std::mt19937_64* random = nullptr,
                                       double of_rate = rate_error) {
    const RateLaw law;
    std::normal_distribution<double> normal;
    const double off = random ? of_rate * normal(*random) : 0;
    std::vector<Reading> readings;
    for (const double speed : {1.0, 10.0}) {
        for (const double pressure : {2.5, 4.0, 8.0, 16.0}) {
            Reading r;
            r.condition = {.normal_stress = pressure * unit,
                           .inertial_number = 0.003 * speed / std::sqrt(pressure),
                           .liquid_content = 0.02};
            r.value = law.predict(Eigen::VectorXd::Constant(1, friction), {r.condition}, {}).value;
            const double scatter = 0.005 * r.condition.normal_stress;
            if (random) {
                r.value(0) +=
                    scatter * normal(*random) +
                    off * std::sqrt(r.condition.inertial_number) * r.condition.normal_stress;
            }
            r.covariance = Eigen::Vector2d(scatter * scatter, 1e-6).asDiagonal();
            readings.push_back(r);
        }
    }
    return readings;
}

Calibration calibration(std::vector<Reading> readings) {
    Calibration c{.readings = std::move(readings), .grains = grains, .liquid = water};
    c.fit.parameters = Eigen::VectorXd::Constant(1, friction);
    c.fit.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-4);
    c.prediction = predict_readings(RateLaw(), c);
    add_cohesion_lines(RateLaw(), c);
    return c;
}

TEST(CommonInertialNumber, GivesOneCohesionAtConstantSpeed) {
    const Calibration c = calibration(at_constant_speed());
    ASSERT_EQ(c.cohesion_lines.size(), 2u);  // measured and simulated
    for (const CohesionLine& line : c.cohesion_lines) {
        EXPECT_EQ(line.points, 8);
        EXPECT_EQ(line.inertial_number, 0);
        EXPECT_NEAR(line.reduced_cohesion.value, cohesion, 1e-9);
        EXPECT_NEAR(line.stress_ratio_intercept.value, friction, 1e-9);
        EXPECT_NEAR(line.cohesion.value, cohesion * unit, 1e-6);
    }
    pendular::expect_told(c.cohesion_notes);
}

TEST(CommonInertialNumber, KeepsTheMisfitAndAddsTheErrorOfTheShift) {
    auto readings = at_constant_speed();
    readings[2].value += Eigen::Vector2d(7, 0.003);
    const Calibration c = calibration(readings);
    const ReadingsAtOneRate at = at_one_inertial_number(RateLaw(), c);
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const double root = std::sqrt(readings[k].condition.inertial_number),
                     stress = readings[k].condition.normal_stress;
        EXPECT_TRUE(at.moved[k]);
        EXPECT_EQ(at.readings[k].condition.inertial_number, 0);
        EXPECT_NEAR(at.readings[k].value(0), readings[k].value(0) - stress * by_rate * root, 1e-9);
        EXPECT_NEAR(at.readings[k].value(1), readings[k].value(1) + packing_by_rate * root, 1e-12);
        // The error of the friction is in both predictions and cancels; that of b does not.
        const double shift = stress * rate_error * root;
        EXPECT_NEAR(at.readings[k].covariance(0, 0), readings[k].covariance(0, 0) + shift * shift,
                    1e-6 * shift * shift);
        const double first = readings[0].condition.normal_stress * rate_error *
                             std::sqrt(readings[0].condition.inertial_number);
        if (k > 0) {
            EXPECT_NEAR(at.measured.covariance(0, 2 * static_cast<Eigen::Index>(k)), first * shift,
                        1e-6 * first * shift);
        }
    }
}

TEST(CommonInertialNumber, LeavesReadingsAtOneInertialNumberAsTheyAre) {
    auto readings = at_constant_speed();
    for (Reading& reading : readings)
        reading.condition.inertial_number = 0.01;
    readings[1].condition.inertial_number = 0.0115;
    readings.push_back(readings[0]);
    readings.back().condition.at_failure = true;
    const Calibration c = calibration(readings);
    const ReadingsAtOneRate at = at_one_inertial_number(RateLaw(), c);
    EXPECT_NEAR(at.inertial_number, 0.0101875, 1e-12);
    for (std::size_t k = 0; k < readings.size(); ++k) {
        EXPECT_FALSE(at.moved[k]);
        EXPECT_EQ(at.readings[k].value, readings[k].value);
        EXPECT_EQ(at.readings[k].condition, readings[k].condition);
    }
}

TEST(CommonInertialNumber, IsTheStatedOne) {
    Calibration c = calibration(at_constant_speed());
    c.cohesion.inertial_number = 0.04;
    add_cohesion_lines(RateLaw(), c);
    ASSERT_EQ(c.cohesion_lines.size(), 2u);
    EXPECT_EQ(c.cohesion_lines[0].inertial_number, 0.04);
    EXPECT_NEAR(c.cohesion_lines[0].stress_ratio_intercept.value, friction + by_rate * 0.2, 1e-9);
}

TEST(CommonInertialNumber, MovesEveryReadingWhereNotAllHaveIt) {
    Calibration c = calibration(at_constant_speed());
    c.cohesion.inertial_number = 1.15 * c.readings[0].condition.inertial_number;
    add_cohesion_lines(RateLaw(), c);
    ASSERT_EQ(c.cohesion_lines.size(), 2u);
    EXPECT_NEAR(c.cohesion_lines[0].reduced_cohesion.value, cohesion, 1e-9);
}

/// The law without a value in the quasi-static limit.
class NoLimit : public RateLaw {
  public:
    Prediction predict(const Eigen::VectorXd& p, const std::vector<Condition>& conditions,
                       PredictionPart what) const override {
        for (const Condition& c : conditions)
            if (c.inertial_number == 0) throw std::domain_error("the logarithm of 0");
        return RateLaw::predict(p, conditions, what);
    }
};

TEST(CommonInertialNumber, IsTheLowestWhereThereIsNoQuasiStaticLimit) {
    Calibration c = calibration(at_constant_speed());
    add_cohesion_lines(NoLimit(), c);
    ASSERT_EQ(c.cohesion_lines.size(), 2u);
    EXPECT_DOUBLE_EQ(c.cohesion_lines[0].inertial_number, 0.003 / std::sqrt(16.0));
    EXPECT_NEAR(c.cohesion_lines[0].reduced_cohesion.value, cohesion, 1e-9);
}

/// The law, shown by an instrument whose torque has an offset of 30 Pa.
class WithOffset : public RateLaw {
  public:
    bool has_instrument() const override { return true; }
    Prediction predict(const Eigen::VectorXd& p, const std::vector<Condition>& conditions,
                       PredictionPart what) const override {
        Prediction result = RateLaw::predict(p, conditions, what);
        for (std::size_t k = 0; k < conditions.size(); ++k)
            if (!conditions[k].ideal_instrument)
                result.value(2 * static_cast<Eigen::Index>(k)) += 30;
        return result;
    }
};

TEST(CommonInertialNumber, FreesReadingsOfTheInstrument) {
    for (const bool at_one_number : {false, true}) {
        std::vector<Reading> readings = at_constant_speed();
        for (Reading& r : readings) {
            if (at_one_number) r.condition.inertial_number = 0.01;
            r.value = WithOffset()
                          .predict(Eigen::VectorXd::Constant(1, friction), {r.condition}, {})
                          .value;
        }
        Calibration c{.readings = readings, .grains = grains, .liquid = water};
        c.fit.parameters = Eigen::VectorXd::Constant(1, friction);
        c.fit.covariance = Eigen::MatrixXd::Constant(1, 1, 1e-4);
        c.prediction = predict_readings(WithOffset(), c);
        add_cohesion_lines(WithOffset(), c);
        ASSERT_EQ(c.cohesion_lines.size(), 2u);
        for (const CohesionLine& line : c.cohesion_lines)
            EXPECT_NEAR(line.cohesion.value, cohesion * unit, 1e-6);
        pendular::expect_told(c.cohesion_notes);
    }
}

/// The law with b fitted.
class FittedRate : public RateLaw {
  public:
    Prediction predict(const Eigen::VectorXd& b, const std::vector<Condition>& conditions,
                       PredictionPart what) const override {
        Prediction result =
            RateLaw::predict(Eigen::VectorXd::Constant(1, friction), conditions, what);
        for (Eigen::Index k = 0; k < result.value.size(); k += 2) {
            const Condition& c = conditions[static_cast<std::size_t>(k / 2)];
            result.jacobian(k, 0) = c.normal_stress * std::sqrt(c.inertial_number);
            result.value(k) += result.jacobian(k, 0) * (b(0) - by_rate);
        }
        result.covariance.setZero();
        result.run_noise.setZero();
        return result;
    }
};

Calibration with_fitted_rate(std::vector<Reading> readings) {
    Calibration c{.readings = std::move(readings), .grains = grains, .liquid = water};
    c.fitted = c.readings.size();
    const Measured measured = stack(c.readings);
    const Eigen::VectorXd guess = Eigen::VectorXd::Constant(1, by_rate);
    const Prediction at = FittedRate().predict(guess, conditions_of(c.readings), {});
    const Eigen::MatrixXd weighted = measured.covariance.inverse() * at.jacobian;
    c.fit.covariance = (at.jacobian.transpose() * weighted).inverse();
    c.fit.parameters =
        guess + c.fit.covariance * weighted.transpose() * (measured.value - at.value);
    c.prediction = predict_readings(FittedRate(), c);
    add_cohesion_lines(FittedRate(), c);
    return c;
}

// 400 studies: the mean error is 0 within 3.9/sqrt(400) of the stated error (one chance in 10,000),
// and the scatter is the stated error within 4/sqrt(2 * 400) = 14 %. Without the error of the
// shift, the intercept would scatter by 1.9 of its errors; without what the shift has in common
// with the readings it was fitted to, by 0.84.
void expect_stated_errors(const std::function<Calibration(std::mt19937_64&)>& of_study) {
    std::mt19937_64 random(5);
    constexpr int count = 400;
    Eigen::Array2d sum = Eigen::Array2d::Zero(), squares = Eigen::Array2d::Zero();
    for (int k = 0; k < count; ++k) {
        const CohesionLine line = of_study(random).cohesion_lines.at(0);
        const Eigen::Array2d error(
            (line.reduced_cohesion.value - cohesion) / line.reduced_cohesion.standard_error,
            (line.stress_ratio_intercept.value - friction) /
                line.stress_ratio_intercept.standard_error);
        sum += error, squares += error.square();
    }
    for (const int k : {0, 1}) {
        EXPECT_NEAR(sum(k) / count, 0, 3.9 / std::sqrt(count));
        EXPECT_NEAR(std::sqrt(squares(k) / count), 1, 0.14);
    }
}

TEST(CommonInertialNumber, StatesTheErrorOfTheCohesion) {
    expect_stated_errors([](auto& random) { return calibration(at_constant_speed(&random)); });
}

TEST(CommonInertialNumber, StatesTheErrorWhereTheShiftWasFittedToTheReadings) {
    expect_stated_errors([](auto& random) {
        std::vector<Reading> readings = at_constant_speed(&random, 0);
        readings.resize(readings.size() / 2);  // one speed
        return with_fitted_rate(readings);
    });
}

}  // namespace calib_common_inertial_number_test
