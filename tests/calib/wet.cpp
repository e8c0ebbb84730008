// Wet readings: from liquid content to bridge volume, surface, prediction and calibration.

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "calib/fit/calibrate_study.h"
#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "calib/model/run_planner.h"
#include "sim/runs/run_request.h"
#include "tests/support/emulator_support.h"
#include "tests/support/golden.h"
#include "tests/support/known_flow.h"
#include "tests/support/small_wet_study.h"

namespace calib_wet_test {

using namespace pendular;
using namespace small_wet;

/// Where not even the behaviour needs good averages.
const Fidelity least{"least", 100, 300, 0.05, 1};

Reading reading_of(const Condition& condition, double ratio, double fraction) {
    Reading r;
    r.condition = condition;
    r.value << ratio * condition.normal_stress, fraction;
    r.covariance << std::pow(0.08 * r.value(0), 2), 0, 0, std::pow(0.012, 2);
    return r;
}

/// A wet run whose network follows a planted law.
dem::RunResult planted_run(double friction, double u, double volume) {
    dem::RunResult run;
    run.parameters.friction = friction;
    run.parameters.inertial_number = 0.01;
    run.parameters.wetting = {1 / u, volume};
    const double v = std::log(volume / 2e-3);
    const auto set = [&](dem::Observable which, double value) {
        run.means[static_cast<std::size_t>(which)] = {value, 0.01};
    };
    set(dem::Observable::contact_coordination, 6 - 2 * friction);
    set(dem::Observable::distant_coordination, 1.6 + 0.4 * v - 0.3 * u);
    set(dem::Observable::effective_coordination, 6.8 + 0.3 * v);
    set(dem::Observable::capillary_shear_stress, (0.07 - 0.02 * v) * u);
    return run;
}

std::vector<dem::RunResult> planted_runs() {
    std::vector<dem::RunResult> runs;
    for (const double u : {0.1, 0.4}) {
        for (const double volume : {5e-4, 1e-3, 4e-3, 8e-3}) {
            for (const double friction : {0.07, 0.11}) {
                runs.push_back(planted_run(friction, u, volume));
            }
        }
    }
    return runs;
}

TEST(WetSettings, CoverThePressuresContentsAndInertialNumbers) {
    std::vector<Condition> conditions = {condition(100, 0)};
    for (const double content : {0.007, 0.03}) {
        for (const double pressure : {2.3, 2.32, 8.0}) {  // 2.3 and 2.32 are one
            for (const double inertial_number : {0.003, 0.03}) {
                conditions.push_back(condition(pressure, content, inertial_number));
            }
        }
    }
    const auto settings = wet_settings_for(conditions, wet_study(), 2e-3);
    ASSERT_EQ(settings.size(), 8u);
    for (const auto& setting : settings) {
        EXPECT_TRUE(std::abs(setting.inverse_pressure * 8 - 1) < 1e-9 ||
                    std::abs(setting.inverse_pressure * 2.3 - 1) < 0.02);
    }
    EXPECT_EQ(wet_settings_for({condition(100, 0)}, wet_study(), 2e-3).size(), 0u);
    std::vector<Condition> many;
    for (int k = 0; k < 100; ++k) {
        many.push_back(condition(1 + 0.2 * k, 0.003 + 0.0005 * k));
    }
    EXPECT_EQ(wet_settings_for(many, wet_study(), 2e-3).size(), most_wet_pairs);
}

TEST(RunPlanner, PredictsWetReadingsFromADesignOfItsOwnAsTheSolverDoes) {
    const Condition wet = condition(2.5, 0.03);
    RunPlanner planner(wet_study(), {wet}, tiny, 1, {.threads = 2},
                       {{}, shipped_hyperparameters()});
    planner.improve(0.2, {wet}, 1), planner.improve(0.2, {wet}, 1);
    const EmulatedSimulation& model = *planner.simulation();
    const Prediction predicted = model.predict(at(0.22), {wet});

    // Fresh runs with other seeds, at the volume that the prediction says holds the liquid.
    const double volume = model.flow_state_at(0.22, wet).bridge_volume;
    double ratio = 0, fraction = 0, content = 0;
    const int runs = 6;
    for (std::uint64_t seed = 500; seed < 500 + runs; ++seed) {
        const auto run = simulate({.friction = 0.22,
                                   .inertial_number = 0.05,
                                   .stiffness_number = 300,
                                   .wetting = dem::Wetting{2.5, volume},
                                   .grains = 150,
                                   .strain = 2,
                                   .seed = seed});
        ratio += run[dem::Observable::stress_ratio].value / runs;
        fraction += run[dem::Observable::solid_fraction].value / runs;
        content += run[dem::Observable::liquid_content].value / runs;
    }
    EXPECT_NEAR(content, 0.03, 0.02 * 0.03);
    // 4 standard errors of the prediction, and the scatter of six runs' mean.
    EXPECT_NEAR(predicted.value(0) / wet.normal_stress, ratio,
                4 * std::sqrt(predicted.covariance(0, 0)) / wet.normal_stress + 0.015);
    EXPECT_NEAR(predicted.value(1), fraction, 4 * std::sqrt(predicted.covariance(1, 1)) + 0.004);
    // Wet is not dry: P* = 2.5 adds about 0.1 to the stress ratio.
    Condition dry = wet;
    dry.liquid_content = 0;
    const auto without = model.predict_at(at(0.22), dry);
    EXPECT_GT(predicted.value(0) / wet.normal_stress, without.value(0) + 0.05);
}

Measurements dry_and_wet() {
    Measurements m;
    m.readings = {reading_of(condition(2.5, 0.03), 0.5, 0.58),
                  reading_of(condition(8, 0), 0.38, 0.60), reading_of(condition(4, 0), 0.38, 0.60),
                  reading_of(condition(8, 0.03), 0.42, 0.59)};
    return m;
}

TEST(CalibrateStudy, PredictsWetReadingsWithTheErrorOfTheDryFit) {
    const Study study = wet_study();
    const Measurements measurements = dry_and_wet();
    const Calibration c =
        calibrate_study(study, measurements, {.fidelity = least, .seed = 3}, {.threads = 2});
    ASSERT_EQ(c.readings.size(), 4u);
    EXPECT_EQ(c.fitted, 2u);
    EXPECT_TRUE(c.readings[1].condition.dry());
    EXPECT_EQ(c.readings[2].condition.liquid_content, 0.03);

    // The dry readings alone give the same fit: wet runs hardly move it.
    Measurements dry = measurements;
    dry.readings = {c.readings[0], c.readings[1]};
    Study dry_study = study;
    dry_study.liquid.reset();
    const Calibration alone =
        calibrate_study(dry_study, dry, {.fidelity = least, .seed = 3}, {.threads = 2});
    EXPECT_NEAR(c.fit.parameters(0), alone.fit.parameters(0), 0.02 * c.fit.standard_error(0));
    EXPECT_LT((c.prediction.value.head(4) - c.fit.prediction.value).norm(),
              1e-9 * c.fit.prediction.value.norm());

    const StudyModel model(study, c);
    const Prediction bare = model.model().predict(c.fit.parameters, conditions_of(c.readings));
    // The measurement's part of the friction's error reaches the wet predictions.
    for (Eigen::Index k = 4; k < 8; ++k) {
        const double slope = bare.jacobian(k, 0);
        EXPECT_GT(c.prediction.covariance(k, k),
                  slope * slope * c.fit.measurement_part(0, 0) * (1 - 1e-9));
    }
    EXPECT_EQ(c.prediction.covariance(0, 4), 0);
}

/// y = A friction + b with errors common to dry and wet readings.
class LinearFlow : public KnownFlow {
  public:
    LinearFlow() : KnownFlow({{.name = "friction", .lower = -9, .upper = 9, .start = 0}}) {}

    Eigen::VectorXd slope, offset;
    Eigen::MatrixXd noise;

    Prediction predict(const Eigen::VectorXd& p, const std::vector<Condition>& conditions,
                       PredictionPart /*what*/) const override {
        std::vector<Eigen::Index> rows;
        for (const auto& condition : conditions) {
            // The inertial number names the row.
            const auto k = static_cast<Eigen::Index>(condition.inertial_number);
            rows.push_back(2 * k);
            rows.push_back(2 * k + 1);
        }
        const Eigen::MatrixXd part = noise(rows, rows);
        return {slope(rows) * p(0) + offset(rows), slope(rows), part, part};
    }
};

/// Two fitted and three predicted readings of a linear model with these errors.
struct TwoSteps {
    std::shared_ptr<LinearFlow> model = std::make_shared<LinearFlow>();
    Calibration c;

    explicit TwoSteps(const Eigen::MatrixXd& noise) {
        std::srand(5);
        model->slope = Eigen::VectorXd::Random(10);
        model->offset = Eigen::VectorXd::Random(10);
        model->noise = noise;
        for (int k = 0; k < 5; ++k) {
            Reading r;
            r.condition.inertial_number = k;
            r.covariance << 0.02, 0.004, 0.004, 0.03;
            c.readings.push_back(r);
        }
        c.fitted = 2;
    }
    void measure(const Eigen::VectorXd& values) {
        for (std::size_t k = 0; k < 5; ++k) {
            c.readings[k].value = values.segment<2>(2 * static_cast<Eigen::Index>(k));
        }
        c.fit = fit_first(c.fitted);
    }
    Fit fit_first(std::size_t count) {
        const std::vector<Reading> seen(c.readings.begin(),
                                        c.readings.begin() + static_cast<std::ptrdiff_t>(count));
        return fit(ModelOfReadings(model, conditions_of(seen)), stack(seen),
                   Eigen::VectorXd::Zero(1));
    }
    /// chi2 of the entries [from, from + n).
    double chi2(Eigen::Index from, Eigen::Index n) const {
        const Prediction p = predict_readings(*model, c);
        const Measured m = stack(c.readings);
        const Eigen::VectorXd misfit = (m.value - p.value).segment(from, n);
        const Eigen::MatrixXd total = (m.covariance + p.covariance).block(from, from, n, n);
        return misfit.dot(total.llt().solve(misfit));
    }
};

Eigen::MatrixXd some_noise() {
    std::srand(6);
    const Eigen::MatrixXd root = 0.1 * Eigen::MatrixXd::Random(10, 10);
    return root * root.transpose();
}

TEST(PredictUnseen, MakesBothChi2AddUpToTheJointOneWhereNoErrorIsShared) {
    Eigen::MatrixXd noise = some_noise();
    noise.topRightCorner(4, 6).setZero();
    noise.bottomLeftCorner(6, 4).setZero();
    TwoSteps two(noise);
    two.measure(Eigen::VectorXd::Random(10));
    const Fit joint = two.fit_first(5);
    EXPECT_NEAR(two.chi2(0, 4) + two.chi2(4, 6), joint.chi2, 1e-6 * joint.chi2);
    EXPECT_NEAR(two.chi2(0, 4), two.c.fit.chi2, 1e-6 * two.c.fit.chi2);
}

TEST(PredictUnseen, GivesWetReadingsTheChi2ThatTheirErrorsHave) {
    // Errors of the model shared by all readings: over 1000 draws the mean wet chi2 is 6, its
    // degrees of freedom, within 3.3 sqrt(12/1000) = 0.36 (1 in 1000). Counting the shared errors
    // twice, once in the fit and once in the prediction, gives another number.
    const Eigen::MatrixXd noise = 4 * some_noise();
    TwoSteps two(noise);
    const Eigen::MatrixXd root = (stack(two.c.readings).covariance + noise).llt().matrixL();
    std::mt19937_64 random(9);
    std::normal_distribution<double> normal;
    constexpr int draws = 1000;
    double mean = 0;
    for (int k = 0; k < draws; ++k) {
        Eigen::VectorXd z(10);
        for (double& one : z) {
            one = normal(random);
        }
        two.measure(0.3 * two.model->slope + two.model->offset + root * z);
        mean += two.chi2(4, 6) / draws;
    }
    EXPECT_NEAR(mean, 6, 0.36);
}

TEST(CalibrateStudy, RefusesWetReadingsItCannotSimulateBeforeAnyRun) {
    Measurements m = dry_and_wet();
    m.readings.push_back(reading_of(condition(0.02, 0.03), 0.5, 0.58));
    m.readings.back().origin = {"wet.csv", 9};
    expect_told({input_error([&] { calibrate_study(wet_study(), m, {.fidelity = least}, {}); })});
}

TEST(CalibrateStudy, FitsWetReadingsTooWhereAsked) {
    Study study = wet_study();
    study.model.fit_to = "all";
    const Calibration c =
        calibrate_study(study, dry_and_wet(), {.fidelity = least, .seed = 3}, {.threads = 2});
    EXPECT_EQ(c.fitted, 4u);
    EXPECT_EQ(c.fit.dof, 7);
    Measurements wet = dry_and_wet();
    std::erase_if(wet.readings, [](const Reading& r) { return r.condition.dry(); });
    for (Reading& r : wet.readings) {
        r.covariance(1, 1) *= 100;  // so that the stresses decide
    }
    const Calibration only =
        calibrate_study(study, wet, {.fidelity = least, .seed = 3}, {.threads = 2});
    EXPECT_EQ(only.fit.dof, 3);
    // Stronger wet readings ask for more friction.
    for (Reading& r : wet.readings) {
        r.value(0) *= 1.3;
    }
    const Calibration stronger =
        calibrate_study(study, wet, {.fidelity = least, .seed = 3}, {.threads = 2});
    EXPECT_GT(stronger.fit.parameters(0), only.fit.parameters(0) + 0.02);
}

}  // namespace calib_wet_test
