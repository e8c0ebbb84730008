#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "calib/calibrate_study.h"
#include "calib/calibration.h"
#include "calib/direct_simulation.h"
#include "calib/response_surface.h"
#include "data/input_error.h"

namespace calib_simulation_test {

using namespace pendular;

/// Soft, small and fast: behaviour, not numbers.
const Fidelity tiny{"tiny", 150, 300, 0.03, 2};

Study stiff_study() {
    Study study;
    study.grains = {
        .diameter = 5e-4, .density = 1050, .youngs_modulus = 3.3e9, .poisson_ratio = 0.3};
    return study;
}
Study raw_study() {
    Study study = stiff_study();
    study.grains.youngs_modulus.reset();
    return study;
}

Condition condition(double normal_stress, double inertial_number) {
    return {.normal_stress = normal_stress, .inertial_number = inertial_number};
}

Eigen::VectorXd at(double friction) {
    return Eigen::VectorXd::Constant(1, friction);
}

TEST(InertialNumbers, AreOneWhereReadingsAgree) {
    EXPECT_EQ(inertial_numbers_for({condition(1e3, 0.0101), condition(2e3, 0.0099)}, 1e-3).size(),
              1u);
}

TEST(InertialNumbers, SpanTheReadings) {
    const auto levels = inertial_numbers_for({condition(1e3, 0.003), condition(1e3, 0.03)}, 1e-3);
    ASSERT_EQ(levels.size(), 3u);
    EXPECT_NEAR(levels.front(), 0.003, 1e-12);
    EXPECT_NEAR(levels.back(), 0.03, 1e-12);
    for (std::size_t k = 1; k < levels.size(); ++k) {
        EXPECT_LE(levels[k] / levels[k - 1], 10.0 / 3 + 1e-9);
    }
}

TEST(InertialNumbers, LeaveSomethingToExtrapolateFrom) {
    EXPECT_EQ(inertial_numbers_for({condition(1e3, 0)}, 3e-3), (std::vector<double>{3e-3, 1e-2}));
    EXPECT_GE(inertial_numbers_for({condition(1e3, 1e-4), condition(1e3, 2e-4)}, 3e-3).size(), 2u);
}

TEST(ResponseSurface, FindsThePolynomialItsRunsCameFrom) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::vector<SurfacePoint> points;
    const auto truth = [](double friction, double inertial_number) {
        const double x = friction_coordinate(friction, 0.1), q = std::pow(inertial_number, 0.75);
        return Eigen::Vector2d(0.25 + 0.1 * x - 0.02 * x * x + q,
                               0.61 - 0.02 * x + 0.001 * x * x - 0.1 * q);
    };
    for (const double friction : {0.05, 0.08, 0.1, 0.13, 0.18}) {
        for (const double inertial_number : {3e-3, 1e-2}) {
            SurfacePoint p{.state = {friction, inertial_number}};
            p.covariance << 4e-6, -2e-7, -2e-7, 9e-8;
            const Eigen::Matrix2d root = p.covariance.llt().matrixL();
            p.value = truth(friction, inertial_number) +
                      root * Eigen::Vector2d(normal(random), normal(random));
            points.push_back(p);
        }
    }
    const ResponseSurface surface(points, 0.1, 0.75, 10);
    EXPECT_EQ(surface.terms(), 5);
    EXPECT_EQ(surface.dof(), 10);
    EXPECT_LT(surface.chi2() / surface.dof(), 3);
    for (const double inertial_number : {0.0, 5e-3}) {
        const Eigen::RowVectorXd row = surface.basis({0.09, inertial_number});
        const Eigen::Vector2d error(
            std::sqrt(row * surface.covariance().topLeftCorner(5, 5) * row.transpose()),
            std::sqrt(row * surface.covariance().bottomRightCorner(5, 5) * row.transpose()));
        const Eigen::Vector2d off =
            surface.value({0.09, inertial_number}) - truth(0.09, inertial_number);
        EXPECT_LT(std::abs(off(0)), 3 * error(0));
        EXPECT_LT(std::abs(off(1)), 3 * error(1));
        EXPECT_LT(error(0), 0.01);
    }
}

TEST(ResponseSurface, HasTheSlopeOfItsOwnValues) {
    std::vector<SurfacePoint> points;
    for (const double friction : {0.05, 0.1, 0.2, 0.3}) {
        for (const double inertial_number : {3e-3, 1e-2, 3e-2}) {
            SurfacePoint p{.state = {friction, inertial_number}};
            p.value << std::sqrt(friction) + inertial_number, 0.6 - 0.1 * friction;
            p.covariance = Eigen::Matrix2d::Identity() * 1e-6;
            points.push_back(p);
        }
    }
    const ResponseSurface s(points, 0.1, 0.75, 10);
    const double d = 1e-5;
    const Eigen::RowVectorXd numeric =
        (s.basis({0.12 + d, 5e-3}) - s.basis({0.12 - d, 5e-3})) / (2 * d);
    EXPECT_LT((numeric - s.basis_slope({0.12, 5e-3})).norm(), 1e-7);
}

TEST(DirectSimulation, PredictsWhatTheSolverDoes) {
    // The prediction at a friction where it made no run agrees with fresh runs of other seeds.
    DirectSimulation model(raw_study(), {condition(1000, 0.03)}, tiny, 1, {});
    model.improve(at(0.2), 1), model.improve(at(0.2), 1);
    const Prediction predicted = model.predict(at(0.22));
    double ratio = 0, fraction = 0;
    const int runs = 6;
    for (std::uint64_t seed = 500; seed < 500 + runs; ++seed) {
        const auto run = dem::run({.friction = 0.22,
                                   .inertial_number = 0.03,
                                   .stiffness_number = 300,
                                   .beads = 150,
                                   .strain = 2,
                                   .seed = seed});
        ratio += run[dem::Observable::stress_ratio].value / runs;
        fraction += run[dem::Observable::solid_fraction].value / runs;
    }
    // 4 standard errors of the prediction, and the scatter of six runs' mean (0.003, 0.001).
    EXPECT_NEAR(predicted.value(0) / 1000, ratio,
                4 * std::sqrt(predicted.covariance(0, 0)) / 1000 + 0.01);
    EXPECT_NEAR(predicted.value(1), fraction, 4 * std::sqrt(predicted.covariance(1, 1)) + 0.003);
}

TEST(DirectSimulation, CorrectsTheSolidFractionToTheStudysStiffness) {
    DirectSimulation raw(raw_study(), {condition(1000, 0.03)}, tiny, 1, {});
    DirectSimulation stiff(stiff_study(), {condition(1000, 0.03)}, tiny, 1, {});
    raw.improve(at(0.2), 1), stiff.improve(at(0.2), 1);
    const Prediction soft = raw.predict(at(0.2)), hard = stiff.predict(at(0.2));
    EXPECT_DOUBLE_EQ(soft.value(0), hard.value(0));
    // Phi rises by about 4/kappa: at kappa 300 by 0.013, of which kappa 23,600 keeps 1 %.
    EXPECT_NEAR(soft.value(1) - hard.value(1), 4.0 / 300, 0.25 * 4.0 / 300);
    EXPECT_GT(hard.covariance(1, 1), soft.covariance(1, 1));
}

TEST(DirectSimulation, LeavesOutRunsThatFailedOrCrystallisedAndSaysSo) {
    DirectSimulation model(raw_study(), {condition(1000, 0.03)}, tiny, 1, {});
    model.improve(at(0.2), 1);
    auto runs = model.runs();
    dem::RunResult failed = runs.front(), crystal = runs.front();
    failed.failure = "the simulation blew up";
    crystal.crystallised = true;
    crystal.means[static_cast<std::size_t>(dem::Observable::solid_fraction)].value = 0.74;
    runs.push_back(failed);
    runs.push_back(crystal);
    DirectSimulation again(raw_study(), {condition(1000, 0.03)}, tiny, 1, {});
    again.restore(runs, 0.2);
    EXPECT_EQ(again.notes().size(), model.notes().size() + 2);
    EXPECT_THAT(again.notes(), testing::Contains(testing::HasSubstr("blew up")));
    EXPECT_THAT(again.notes(), testing::Contains(testing::HasSubstr("crystallised")));
    DirectSimulation without(raw_study(), {condition(1000, 0.03)}, tiny, 1, {});
    without.restore(model.runs(), 0.2);
    EXPECT_EQ(again.predict(at(0.2)).value, without.predict(at(0.2)).value);
    EXPECT_THROW(
        DirectSimulation(raw_study(), {condition(1000, 0.03)}, tiny, 1, {}).restore({failed}, 0.2),
        dem::SimulationError);
}

TEST(CalibrateStudy, DoesNotRunAfterErrorsThatRunsCannotLower) {
    // A stiff study in the quasi-static limit with sharp readings: the corrections' errors
    // dominate. The fit must converge and say so, not order runs without end.
    const Fidelity coarse{"coarse", 150, 300, 0.03, 4};
    Measurements m;
    Reading reading;
    reading.condition = condition(1000, 0);
    reading.value << 300, 0.60;
    reading.covariance << std::pow(3.0, 2), 0, 0, std::pow(2e-4, 2);
    m.readings = {reading};
    const Calibration c = calibrate_study(stiff_study(), m, {.fidelity = coarse}, {.threads = 2});
    EXPECT_TRUE(c.fit.converged) << c.fit.message;
    EXPECT_LT(c.runs.size(), 150u);
    EXPECT_LT(c.fit.run_part(0, 0), 0.2 * c.fit.covariance(0, 0));
    EXPECT_GT(c.fit.simulation_error(0), 2 * c.fit.measurement_error(0));
    EXPECT_THAT(c.notes, testing::Contains(testing::HasSubstr("corrections")));
}

TEST(CalibrateStudy, RefusesBeadsSofterThanItsCorrectionHolds) {
    Study soft = stiff_study();
    soft.grains.youngs_modulus = 3.3e3;  // kPa written for GPa, say
    Measurements m;
    m.readings.resize(1);
    m.readings[0].condition = condition(1000, 0.03);
    try {
        calibrate_study(soft, m, {.fidelity = tiny}, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("youngs_modulus"), std::string::npos)
            << error.what();
    }
}

TEST(DirectSimulation, HasDerivativesOfItsOwnPredictions) {
    DirectSimulation model(stiff_study(), {condition(1000, 0.03), condition(500, 0.1)}, tiny, 1,
                           {});
    model.improve(at(0.2), 1);
    const double d = 1e-5;
    const Eigen::VectorXd numeric =
        (model.predict(at(0.2 + d)).value - model.predict(at(0.2 - d)).value) / (2 * d);
    EXPECT_LT((numeric - model.predict(at(0.2)).jacobian.col(0)).norm(), 1e-5 * numeric.norm());
}

TEST(CalibrateStudy, FindsAPlantedFrictionThroughTheSolver) {
    // The truth is the mean of runs with seeds and a size that the fit never uses.
    const double truth = 0.25;
    Measurements measurements;
    double ratio = 0, fraction = 0;
    for (std::uint64_t seed = 900; seed < 906; ++seed) {
        const auto run = dem::run({.friction = truth,
                                   .inertial_number = 0.03,
                                   .stiffness_number = 300,
                                   .beads = 200,
                                   .strain = 4,
                                   .seed = seed});
        ratio += run[dem::Observable::stress_ratio].value / 6;
        fraction += run[dem::Observable::solid_fraction].value / 6;
    }
    for (const double stress : {500.0, 1000.0}) {
        Reading reading;
        reading.condition = condition(stress, 0.03);
        reading.value << ratio * stress, fraction;
        reading.covariance << std::pow(0.02 * ratio * stress, 2), 0, 0, std::pow(0.003, 2);
        measurements.readings.push_back(reading);
    }
    const Calibration c =
        calibrate_study(raw_study(), measurements, {.fidelity = tiny, .seed = 1}, {.threads = 2});
    EXPECT_TRUE(c.fit.converged);
    EXPECT_NEAR(c.fit.parameters(0), truth, 3 * c.fit.standard_error(0));
    EXPECT_LT(c.fit.standard_error(0), 0.05);
    EXPECT_GE(c.runs.size(), 11u);

    // Made again from its runs, the model says the same.
    const Prediction again = predict_readings(StudyModel(raw_study(), c).model(), c);
    EXPECT_LT((again.value - c.fit.prediction.value).norm(), 1e-12 * again.value.norm());
    EXPECT_LT((again.covariance - c.fit.prediction.covariance).norm(),
              1e-9 * again.covariance.norm());
}

TEST(CalibrateStudy, RefusesAReadingTooFastToSimulate) {
    Measurements fast;
    fast.readings.resize(1);
    fast.readings[0].origin = {"fast.csv", 7};
    fast.readings[0].condition = condition(1000, 0.8);
    try {
        calibrate_study(raw_study(), fast, {.fidelity = tiny}, {});
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("fast.csv:7"), std::string::npos) << error.what();
    }
}

TEST(CalibrateStudy, NeedsADryReading) {
    Measurements wet;
    wet.readings.resize(1);
    wet.readings[0].condition.liquid_content = 0.03;
    EXPECT_THROW(calibrate_study(raw_study(), wet, {.fidelity = tiny}, {}), InputError);
}

}  // namespace calib_simulation_test
