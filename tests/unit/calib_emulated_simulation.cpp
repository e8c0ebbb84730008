#include "calib/calibrate_study.h"
#include "calib/emulated_simulation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "calib/calibration.h"
#include "calib/study_model.h"
#include "emulator_support.h"
#include "workflow/json.h"

namespace pendular::calib_emulated_simulation_test {

using testing::HasSubstr;

/// Soft, small and fast: behaviour, not numbers.
const Fidelity tiny{"tiny", 150, 500, 0.03, 2};

Study wet_study() {
    Study study;
    study.grains = {
        .diameter = 5e-4, .density = 1050, .youngs_modulus = 3.3e9, .poisson_ratio = 0.3};
    study.liquid = Liquid{.surface_tension = 0.0206, .contact_angle = 0, .viscosity = 0.05};
    return study;
}

Condition dry_at(double stress, double inertial_number) {
    return {.normal_stress = stress, .inertial_number = inertial_number};
}
Condition wet_at(double stress, double inertial_number, double content) {
    return {.normal_stress = stress, .inertial_number = inertial_number, .liquid_content = content};
}

Eigen::VectorXd at(double friction) {
    return Eigen::VectorXd::Constant(1, friction);
}

/// Runs of tiny fidelity over a range, with real physics; made once.
const std::vector<dem::RunResult>& tiny_runs() {
    static const auto runs = [] {
        std::vector<dem::RunParameters> wanted;
        for (const double friction : {0.05, 0.1, 0.2, 0.3, 0.4, 0.5}) {
            for (const double inertial_number : {0.05, 0.1}) {
                for (const std::uint64_t seed : {1, 2}) {
                    wanted.push_back({.friction = friction,
                                      .inertial_number = inertial_number,
                                      .stiffness_number = 500,
                                      .beads = 150,
                                      .strain = 4,
                                      .seed = seed});
                }
            }
        }
        return run_all(wanted, {.threads = 2});
    }();
    return runs;
}

Measurements measured_at(const std::vector<Condition>& conditions, const FlowModel& truth,
                         double friction) {
    Measurements measurements;
    const Prediction prediction = truth.predict_conditions(at(friction), conditions);
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        Reading reading{.condition = conditions[k]};
        reading.value = prediction.value.segment<2>(2 * static_cast<Eigen::Index>(k));
        reading.covariance.diagonal() << std::pow(0.02 * reading.value(0), 2), 1e-5;
        measurements.readings.push_back(reading);
    }
    return measurements;
}

TEST(EmulatedSimulation, HasDerivativesOfItsOwnPredictions) {
    const std::vector<Condition> conditions = {dry_at(1000, 0.003), dry_at(300, 0),
                                               wet_at(300, 0.003, 0.03), wet_at(600, 0.01, 0.007)};
    const EmulatedSimulation model(wet_study(), conditions, fidelity_named("quick"), 1, {},
                                   {shipped_runs(), shipped_scales(), false});
    constexpr double step = 1e-4;
    for (const double friction : {0.05, 0.2}) {
        const Prediction here = model.predict(at(friction));
        const auto value = [&](double by) { return model.predict(at(friction + by)).value; };
        const Eigen::VectorXd difference =
            (8 * (value(step) - value(-step)) - (value(2 * step) - value(-2 * step))) / (12 * step);
        for (Eigen::Index k = 0; k < difference.size(); ++k) {
            EXPECT_NEAR(here.jacobian(k, 0), difference(k), 1e-5 * (1 + std::abs(difference(k))));
        }
        EXPECT_EQ(Eigen::LLT<Eigen::MatrixXd>(here.covariance).info(), Eigen::Success);
    }
    const double slope = model.effective_coordination(0.2, conditions[2]).by_friction;
    EXPECT_NEAR(slope,
                (model.effective_coordination(0.2 + step, conditions[2]).value -
                 model.effective_coordination(0.2 - step, conditions[2]).value) /
                    (2 * step),
                1e-4);
}

TEST(EmulatedSimulation, OrdersNothingWhereItMayNot) {
    EmulatedSimulation model(wet_study(), {dry_at(1000, 0.003), wet_at(5, 0.003, 0.03)}, tiny, 1,
                             {}, {shipped_runs(), shipped_scales(), false});
    const std::size_t before = model.runs().size();
    model.improve(at(0.2), 5), model.improve(at(0.2), 5), model.learn_wet(at(0.2), 2);
    EXPECT_EQ(model.runs().size(), before);
    EXPECT_TRUE(model.orders().empty());
}

TEST(EmulatedSimulation, SaysWhereItKnowsLessThanTheReadings) {
    const std::vector<Condition> conditions = {dry_at(1000, 0.003), dry_at(300, 0.03)};
    const KnownRuns known{shipped_runs(), shipped_scales(), false};
    const EmulatedSimulation model(wet_study(), conditions, fidelity_named("quick"), 1, {}, known);
    Measurements measurements = measured_at(conditions, model, 0.2);
    CalibrationRequest request{.fidelity = fidelity_named("quick"), .known = known};
    request.options.fewest_rounds = request.options.most_rounds = 1;
    const auto notes = [&] {
        return calibrate_study(wet_study(), measurements, request, {}).notes;
    };
    const auto says_so = testing::Contains(HasSubstr("add --confirm"));
    EXPECT_THAT(notes(), testing::Not(says_so));
    for (Reading& reading : measurements.readings) {
        reading.covariance /= 1e4;  // errors of 0.02 %
    }
    EXPECT_THAT(notes(), says_so);
}

TEST(EmulatedSimulation, OrdersWhatLiesBeyondItsRuns) {
    EmulatedSimulation model(wet_study(), {dry_at(1000, 0.3)}, tiny, 1, {.threads = 2},
                             {tiny_runs(), {}, true});
    const double before = model.predict(at(0.2)).covariance(0, 0);
    model.improve(at(0.2), 1);
    ASSERT_EQ(model.orders().size(), 1u);
    EXPECT_THAT(model.orders()[0].why, HasSubstr("inertial number 0.3 is above 0.1"));
    EXPECT_GE(model.orders()[0].runs, 4u);
    EXPECT_LT(model.predict(at(0.2)).covariance(0, 0), before / 4);
    EXPECT_EQ(model.emulator().beyond({0.2, 0.3}), "");
}

TEST(EmulatedSimulation, IsConfirmedByRunsThatAgreeAndNotByOthers) {
    EmulatedSimulation right(wet_study(), {dry_at(1000, 0.06)}, tiny, 1, {.threads = 2},
                             {tiny_runs(), {}, true});
    right.improve(at(0.2), 1), right.improve(at(0.2), 1);
    EXPECT_TRUE(right.confirmed());
    // What is known says a stress ratio a sixth too high.
    auto wrong_runs = tiny_runs();
    for (auto& run : wrong_runs) {
        run.means[0].value *= 1.17;
    }
    EmulatedSimulation wrong(wet_study(), {dry_at(1000, 0.06)}, tiny, 1, {.threads = 2},
                             {wrong_runs, {}, true});
    wrong.improve(at(0.2), 1), wrong.improve(at(0.2), 1);
    EXPECT_FALSE(wrong.confirmed());
    EXPECT_EQ(wrong.orders()[0].why, "to confirm the optimum");
    EXPECT_FALSE(wrong.runs().size() == wrong_runs.size());
}

TEST(EmulatedSimulation, TakesRunsThatCanServeOnly) {
    auto runs = shipped_runs();
    const std::size_t all = runs.size();
    runs[0].parameters.beads = 100;
    runs[1].parameters.poisson_ratio = 0.05;
    runs[2].crystallised = true;
    const Fidelity quick = fidelity_named("quick");
    EXPECT_EQ(EmulatedSimulation::serving(wet_study(), quick, runs).size(), all - 3);
    Study printed = wet_study();
    printed.model.bridge_force = Form::as_printed;
    for (const auto& run : EmulatedSimulation::serving(printed, quick, runs)) {
        EXPECT_FALSE(run.parameters.wetting);
    }
}

TEST(EmulatedCalibration, FindsAPlantedFrictionAtOnceAndCanBeReadBack) {
    const Study study = wet_study();
    const std::vector<Condition> conditions = {dry_at(300, 0.003), dry_at(1000, 0.003),
                                               dry_at(1000, 0.03), wet_at(300, 0.003, 0.03),
                                               wet_at(1000, 0.003, 0.03)};
    const KnownRuns known{shipped_runs(), shipped_scales(), false};
    const Fidelity quick = fidelity_named("quick");
    const EmulatedSimulation truth(study, conditions, quick, 1, {}, known);
    CalibrationRequest request{.fidelity = quick, .known = known};
    request.options.fewest_rounds = request.options.most_rounds = 1;
    const Calibration c = calibrate_study(study, measured_at(conditions, truth, 0.17), request, {});
    EXPECT_TRUE(c.fit.converged);
    EXPECT_NEAR(c.fit.parameters(0), 0.17, 1e-4);
    EXPECT_GT(c.fit.simulation_error(0), 0);
    EXPECT_EQ(c.cohesion_lines.size(), 2u);  // measured and simulated
    // From its own file the model comes back as it was.
    const Prediction again = predict_readings(StudyModel(study, c).model(), c);
    EXPECT_LT((again.value - c.prediction.value).norm(), 1e-9 * c.prediction.value.norm());
}

TEST(EmulatedCalibration, IsNotSettledUntilFreshRunsAgree) {
    // An atlas that is wrong by a sixth would give a much lower friction; the runs it orders put it
    // right, or it says that it did not settle.
    const Study study = wet_study();
    const std::vector<Condition> conditions = {dry_at(1000, 0.06)};
    const EmulatedSimulation truth(study, conditions, tiny, 1, {}, {tiny_runs(), {}, false});
    const Measurements measured = measured_at(conditions, truth, 0.25);
    const auto calibrated = [&](double factor, bool orders) {
        auto runs = tiny_runs();
        for (auto& run : runs) {
            run.means[0].value *= factor;
        }
        CalibrationRequest request{.fidelity = tiny, .known = KnownRuns{runs, {}, orders}};
        request.options.fewest_rounds = orders ? 2 : 1;
        request.options.most_rounds = orders ? 4 : 1;
        return calibrate_study(study, measured, request, {.threads = 2});
    };
    const Calibration right = calibrated(1, true), blind = calibrated(1.17, false),
                      wrong = calibrated(1.17, true);
    EXPECT_NEAR(right.fit.parameters(0), 0.25, 3 * right.fit.standard_error(0));
    EXPECT_FALSE(right.orders.empty());
    EXPECT_LT(blind.fit.parameters(0), 0.25 - 3 * blind.fit.standard_error(0));
    EXPECT_TRUE(!wrong.fit.converged ||
                std::abs(wrong.fit.parameters(0) - 0.25) < 3 * wrong.fit.standard_error(0));
    EXPECT_GT(wrong.rounds, 2);
}

}  // namespace pendular::calib_emulated_simulation_test
