#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "calib/model/run_planner.h"
#include "data/input_error.h"
#include "sim/runs/run_request.h"
#include "tests/support/emulator_support.h"
#include "tests/support/golden.h"

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

TEST(RunPlanner, PredictsFromADesignOfItsOwnWhatTheSolverDoes) {
    // The prediction at a friction where it made no run agrees with fresh runs of other seeds.
    const std::vector<Condition> conditions = {condition(1000, 0.03)};
    RunPlanner planner(raw_study(), conditions, tiny, 1, {}, {{}, shipped_hyperparameters()});
    planner.improve(0.2, without_effects(conditions), 1),
        planner.improve(0.2, without_effects(conditions), 1);
    const Prediction predicted = planner.simulation()->predict(at(0.22), conditions);
    double ratio = 0, fraction = 0;
    const int runs = 6;
    for (std::uint64_t seed = 500; seed < 500 + runs; ++seed) {
        const auto run = simulate({.friction = 0.22,
                                   .inertial_number = 0.03,
                                   .stiffness_number = 300,
                                   .grains = 150,
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

TEST(EmulatedSimulation, CorrectsTheSolidFractionToTheStudysStiffness) {
    const std::vector<Condition> conditions = {condition(1000, 0.03)};
    const auto predicted = [&](const Study& study) {
        const RunPlanner planner(study, conditions, tiny, 1, {}, {{}, shipped_hyperparameters()});
        return planner.simulation()->predict(at(0.2), conditions);
    };
    const Prediction soft = predicted(raw_study()), hard = predicted(stiff_study());
    EXPECT_DOUBLE_EQ(soft.value(0), hard.value(0));
    // Phi rises by about 4/kappa: at kappa 300 by 0.013, of which kappa 23,600 keeps 1 %.
    EXPECT_NEAR(soft.value(1) - hard.value(1), 4.0 / 300, 0.25 * 4.0 / 300);
    // The error of the correction grows with the distance from rigid beads.
    EXPECT_GT(soft.covariance(1, 1), hard.covariance(1, 1));
}

TEST(CalibrateStudy, DoesNotRunAfterErrorsThatRunsCannotLower) {
    // Stiff beads with a sharp reading: the error of the correction to their stiffness is larger
    // than the noise of the runs. The fit must converge and say so, not order runs without end.
    const Fidelity coarse{"coarse", 300, 300, 0.05, 6};
    Measurements m;
    Reading reading;
    reading.condition = condition(1000, 0.05);
    reading.value << 300, 0.60;
    reading.covariance << std::pow(3.0, 2), 0, 0, std::pow(2e-4, 2);
    m.readings = {reading};
    const Calibration c = calibrate_study(stiff_study(), m, {.fidelity = coarse}, {.threads = 2});
    EXPECT_TRUE(c.fit.converged) << c.fit.message;
    EXPECT_LT(c.runs.size(), 150u);
    EXPECT_LT(c.fit.run_part(0, 0), 0.2 * c.fit.covariance(0, 0));
    EXPECT_GT(std::pow(c.fit.simulation_error(0), 2), 2 * c.fit.run_part(0, 0));
    expect_told(c.notes);
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

TEST(CalibrateStudy, FindsAPlantedFrictionThroughTheSolver) {
    // The truth is the mean of runs with seeds and a size that the fit never uses.
    const double truth = 0.25;
    Measurements measurements;
    double ratio = 0, fraction = 0;
    for (std::uint64_t seed = 900; seed < 906; ++seed) {
        const auto run = simulate({.friction = truth,
                                   .inertial_number = 0.03,
                                   .stiffness_number = 300,
                                   .grains = 200,
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
