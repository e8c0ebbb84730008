#include "calib/model/emulated_simulation.h"
#include "calib/fit/calibrate_study.h"

#include <Eigen/Dense>
#include <thread>

#include "calib/fit/calibration.h"
#include "calib/fit/study_model.h"
#include "calib/model/run_planner.h"
#include "tests/support/emulator_support.h"
#include "tests/support/golden.h"

namespace pendular::calib_emulated_simulation_test {

/// Soft, small and fast: behaviour, not numbers.
const Fidelity tiny{"tiny", 150, 500, 0.03, 2};

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
                                      .grains = 150,
                                      .strain = 4,
                                      .seed = seed});
                }
            }
        }
        return run_all(wanted, {.threads = 2});
    }();
    return runs;
}

Measurements measured_at(const std::vector<Condition>& conditions, const Predictor& truth,
                         double friction) {
    Measurements measurements;
    const Prediction prediction = truth.predict(at(friction), conditions);
    for (std::size_t k = 0; k < conditions.size(); ++k) {
        Reading reading{.condition = conditions[k]};
        reading.value = prediction.value.segment<2>(2 * static_cast<Eigen::Index>(k));
        reading.covariance.diagonal() << std::pow(0.02 * reading.value(0), 2), 1e-5;
        measurements.readings.push_back(reading);
    }
    return measurements;
}

EmulatedSimulation emulated_from(const Study& study, const Fidelity& fidelity,
                                 const std::vector<dem::RunResult>& runs,
                                 const EmulatorHyperparameters& hyperparameters = {}) {
    return {study, fidelity, Emulator(runs, hyperparameters)};
}

TEST(EmulatedSimulation, HasDerivativesOfItsOwnPredictions) {
    const std::vector<Condition> conditions = {dry_at(1000, 0.003), dry_at(300, 0),
                                               wet_at(300, 0.003, 0.03), wet_at(600, 0.01, 0.007)};
    const EmulatedSimulation model = emulated_from(stiff_wet_study(), fidelity_named("quick"),
                                                   shipped_runs(), shipped_hyperparameters());
    constexpr double step = 1e-4;
    for (const double friction : {0.05, 0.2}) {
        const Prediction here = model.predict(at(friction), conditions);
        const auto value = [&](double by) {
            return model.predict(at(friction + by), conditions).value;
        };
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

/// Predictions of one thread while others ask for the same and for more, of an emulator that has
/// learned nothing yet.
TEST(EmulatedSimulation, SaysTheSameToManyThreads) {
    const std::vector<Condition> conditions = {dry_at(1000, 0.003), wet_at(300, 0.003, 0.03),
                                               wet_at(600, 0.01, 0.007)};
    const auto model = [] {
        return emulated_from(stiff_wet_study(), fidelity_named("quick"), shipped_runs(),
                             shipped_hyperparameters());
    };
    const Prediction alone = model().predict(at(0.2), conditions);
    const EmulatedSimulation shared = model();
    std::vector<Prediction> said(4);
    {
        std::vector<std::jthread> threads;
        for (Prediction& one : said) {
            threads.emplace_back([&] {
                for (const double friction : {0.1, 0.3, 0.2}) {
                    one = shared.predict(at(friction), conditions);
                }
            });
        }
    }
    for (const Prediction& one : said) {
        EXPECT_EQ(one.value, alone.value);
        EXPECT_EQ(one.covariance, alone.covariance);
    }
}

TEST(RunPlanner, OrdersNothingWhereItMayNot) {
    const std::vector<Condition> conditions = {dry_at(1000, 0.003), wet_at(5, 0.003, 0.03)};
    RunPlanner planner(stiff_wet_study(), conditions, tiny, 1, {},
                       {shipped_runs(), shipped_hyperparameters(), false});
    const std::size_t before = planner.simulation()->emulator().runs().size();
    planner.improve(0.2, without_effects(conditions), 5),
        planner.improve(0.2, without_effects(conditions), 5);
    planner.improve_wet(0.2, without_effects(conditions));
    EXPECT_EQ(planner.simulation()->emulator().runs().size(), before);
    EXPECT_TRUE(planner.simulated().empty());
}

TEST(EmulatedSimulation, SaysWhereItKnowsLessThanTheReadings) {
    const std::vector<Condition> conditions = {dry_at(1000, 0.003), dry_at(300, 0.03)};
    const KnownRuns known{shipped_runs(), shipped_hyperparameters(), false};
    const EmulatedSimulation model = emulated_from(stiff_wet_study(), fidelity_named("quick"),
                                                   known.runs, known.hyperparameters);
    Measurements measurements = measured_at(conditions, model, 0.2);
    CalibrationRequest request{.fidelity = fidelity_named("quick"), .known = known};
    request.options.fewest_rounds = request.options.most_rounds = 1;
    const auto notes = [&] {
        return calibrate_study(stiff_wet_study(), measurements, request, {}).notes;
    };
    const auto before = notes();
    for (Reading& reading : measurements.readings) {
        reading.covariance /= 1e4;  // errors of 0.02 %
    }
    const auto after = notes();
    EXPECT_EQ(after.size(), before.size() + 1);
    expect_told(after);
}

TEST(RunPlanner, OrdersWhatLiesBeyondItsRuns) {
    const std::vector<Condition> conditions = {dry_at(1000, 0.3)};
    RunPlanner planner(stiff_wet_study(), conditions, tiny, 1, {.threads = 2},
                       {tiny_runs(), {}, true});
    const auto variance = [&] {
        return planner.simulation()->predict(at(0.2), conditions).covariance(0, 0);
    };
    const double before = variance();
    planner.improve(0.2, without_effects(conditions), 1);
    ASSERT_EQ(planner.simulated().size(), 1u);
    expect_told({planner.simulated()[0].why});
    EXPECT_GE(planner.simulated()[0].runs, 4u);
    EXPECT_LT(variance(), before / 4);
    EXPECT_EQ(planner.simulation()->emulator().beyond({0.2, 0.3}), "");
}

TEST(RunPlanner, IsConfirmedByRunsThatAgreeAndNotByOthers) {
    const std::vector<Condition> conditions = {dry_at(1000, 0.06)};
    RunPlanner right(stiff_wet_study(), conditions, tiny, 1, {.threads = 2},
                     {tiny_runs(), {}, true});
    right.improve(0.2, without_effects(conditions), 1),
        right.improve(0.2, without_effects(conditions), 1);
    EXPECT_TRUE(right.confirmed());
    // What is known says a stress ratio a sixth too high.
    auto wrong_runs = tiny_runs();
    for (auto& run : wrong_runs) {
        run.means[0].value *= 1.17;
    }
    RunPlanner wrong(stiff_wet_study(), conditions, tiny, 1, {.threads = 2},
                     {wrong_runs, {}, true});
    wrong.improve(0.2, without_effects(conditions), 1),
        wrong.improve(0.2, without_effects(conditions), 1);
    EXPECT_FALSE(wrong.confirmed());
    EXPECT_EQ(wrong.simulated()[0].why, "to confirm the optimum");
    EXPECT_GT(wrong.simulation()->emulator().runs().size(), wrong_runs.size());
}

TEST(KnownRuns, AreThoseThatCanServe) {
    auto runs = shipped_runs();
    const std::size_t all = runs.size();
    runs[0].parameters.grains = 100;
    runs[1].parameters.poisson_ratio = 0.05;
    runs[2].crystallised = true;
    const Fidelity quick = fidelity_named("quick");
    EXPECT_EQ(runs_serving(stiff_wet_study(), quick, runs).size(), all - 3);
    Study printed = stiff_wet_study();
    printed.model.bridge_force = FormulaVariant::as_printed;
    for (const auto& run : runs_serving(printed, quick, runs)) {
        EXPECT_FALSE(run.parameters.wetting);
    }
}

TEST(EmulatedCalibration, FindsAPlantedFrictionAtOnceAndCanBeReadBack) {
    const Study study = stiff_wet_study();
    const std::vector<Condition> conditions = {dry_at(300, 0.003), dry_at(1000, 0.003),
                                               dry_at(1000, 0.03), wet_at(300, 0.003, 0.03),
                                               wet_at(1000, 0.003, 0.03)};
    const KnownRuns known{shipped_runs(), shipped_hyperparameters(), false};
    const Fidelity quick = fidelity_named("quick");
    const EmulatedSimulation truth = emulated_from(study, quick, known.runs, known.hyperparameters);
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

TEST(EmulatedCalibration, GoesOnWhereFreshRunsDisagree) {
    // An atlas that is wrong by a sixth gives a much lower friction. The runs that the calibration
    // orders move the friction towards the true one, and a note says that they disagreed.
    const Study study = stiff_wet_study();
    const std::vector<Condition> conditions = {dry_at(1000, 0.06)};
    const EmulatedSimulation truth = emulated_from(study, tiny, tiny_runs());
    const Measurements measured = measured_at(conditions, truth, 0.25);
    const auto calibrated = [&](double factor, bool orders, std::uint64_t seed) {
        auto runs = tiny_runs();
        for (auto& run : runs) {
            run.means[0].value *= factor;
        }
        CalibrationRequest request{.fidelity = tiny, .known = KnownRuns{runs, {}, orders}};
        request.seed = seed;
        request.options.fewest_rounds = orders ? 2 : 1;
        request.options.most_rounds = orders ? 4 : 1;
        return calibrate_study(study, measured, request, {.threads = 2});
    };
    const Calibration right = calibrated(1, true, 1), blind = calibrated(1.17, false, 1);
    EXPECT_NEAR(right.fit.parameters(0), 0.25, 3 * right.fit.standard_error(0));
    EXPECT_FALSE(right.simulated.empty());
    EXPECT_LT(blind.fit.parameters(0), 0.25 - 3 * blind.fit.standard_error(0));
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Calibration wrong = calibrated(1.17, true, seed);
        EXPECT_GT(wrong.rounds, 2);
        EXPECT_LT(std::abs(wrong.fit.parameters(0) - 0.25),
                  0.7 * std::abs(blind.fit.parameters(0) - 0.25));
        EXPECT_TRUE(std::ranges::any_of(wrong.notes, [](const std::string& note) {
            return note.find("differed from the emulator's predictions") != std::string::npos;
        }));
    }
}

/// The earlier runs claim to have taken no time, so that runs seem affordable; the time then ends
/// before the first of them does.
TEST(EmulatedCalibration, SaysThatNoSimulationEndedInTime) {
    const Study study = stiff_wet_study();
    const EmulatedSimulation truth = emulated_from(study, tiny, tiny_runs());
    const Measurements measured = measured_at({dry_at(1000, 0.06)}, truth, 0.25);
    for (const double seconds : {0.0, 0.02}) {
        auto runs = tiny_runs();
        for (auto& run : runs) {
            run.wall_seconds = 1e-9;
        }
        CalibrationRequest request{.fidelity = tiny, .known = KnownRuns{runs, {}, true}};
        request.options.fewest_rounds = 2;
        request.budget = RunBudget(seconds);
        const Calibration c = calibrate_study(study, measured, request, {.threads = 2});
        EXPECT_TRUE(c.simulated.empty());
        expect_told(c.notes);
    }
}

TEST(EmulatedCalibration, SaysThatTheTimeEndedBeforeTheFirstOfAllSimulations) {
    const Study study = stiff_wet_study();
    const Measurements measured =
        measured_at({dry_at(1000, 0.06)}, emulated_from(study, tiny, tiny_runs()), 0.25);
    CalibrationRequest request{.fidelity = tiny, .known = KnownRuns{{}, {}, true}};
    request.budget = RunBudget(0.001);
    try {
        calibrate_study(study, measured, request, {.threads = 1});
        FAIL();
    } catch (const dem::SimulationError& error) {
        expect_told({error.what()});
    }
}

}  // namespace pendular::calib_emulated_simulation_test
