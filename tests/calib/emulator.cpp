#include "calib/emulator/emulator.h"
#include "calib/emulator/emulated_observables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <chrono>

#include "calib/emulator/emulated_state.h"
#include "calib/emulator/gaussian_process.h"
#include "calib/emulator/known_runs.h"
#include "tests/support/emulator_support.h"
#include "tests/support/golden.h"

namespace pendular::calib_emulator_test {

using dem::Observable;

const Emulator& shipped() {
    static const Emulator emulator(shipped_runs(), shipped_hyperparameters());
    return emulator;
}

/// The state with one input moved.
FlowState moved(FlowState state, Input input, double by) {
    switch (input) {
        case Input::friction:
            state.friction += by;
            break;
        case Input::log_inertial_number:
            state.inertial_number *= std::exp(by);
            break;
        case Input::inverse_pressure:
            state.inverse_pressure += by;
            break;
        default:
            state.bridge_volume += by;
    }
    return state;
}

TEST(Emulator, LearnsNothingOfPlainBeadsFromRunsWithEffects) {
    const auto plain = invented_runs(60, 1);
    auto with_odd_one = plain;
    with_odd_one.push_back(plain.front());
    with_odd_one.back().parameters.effects = {{"rolling-resistance", {0.2}}};
    with_odd_one.back().means[static_cast<std::size_t>(Observable::stress_ratio)].value = 5;
    const Query query{{0.12, 0.01}, Observable::stress_ratio};
    EXPECT_EQ(Emulator(plain, shipped_hyperparameters()).mean({query}),
              Emulator(with_odd_one, shipped_hyperparameters()).mean({query}));
}

/// An effect whose change is twice its amplitude times friction, learned from 20 runs.
TEST(Emulator, AddsTheChangeThatRunsWithAnEffectShow) {
    auto runs = invented_runs(120, 1);
    auto changed = invented_runs(40, 2);
    for (auto& run : changed) {
        const double amplitude = run.parameters.seed % 2 == 0 ? 0.05 : 0.2;
        run.parameters.effects = {{"dry-adhesion", {amplitude}}};
        run.means[static_cast<std::size_t>(Observable::stress_ratio)].value +=
            2 * amplitude * run.parameters.friction;
        runs.push_back(run);
    }
    const Emulator emulator(runs, shipped_hyperparameters());
    for (const double friction : {0.1, 0.3, 0.5}) {
        for (const double amplitude : {0.0, 0.1, 0.2}) {
            const FlowState plain{friction, 0.01};
            FlowState with_it = plain;
            with_it.effects = {{"dry-adhesion", {amplitude}}};
            const std::vector<Query> both = {{with_it, Observable::stress_ratio},
                                             {plain, Observable::stress_ratio}};
            const Eigen::VectorXd said = emulator.mean(both);
            const Eigen::MatrixXd covariance = emulator.covariance(both);
            const double error = std::sqrt(
                std::max(0.0, covariance(0, 0) + covariance(1, 1) - 2 * covariance(0, 1)));
            EXPECT_NEAR(said(0) - said(1), 2 * amplitude * friction, 4 * error + 1e-12)
                << friction << ", " << amplitude;
            EXPECT_LT(error, 0.02);  // a tenth of the largest change
            if (amplitude == 0) {
                EXPECT_EQ(said(0), said(1));  // vanishes at neutral, bit for bit
            }
        }
    }
}

TEST(Emulator, CountsTheErrorWithoutAnEffectOnceInPredictionsWithIt) {
    // Few plain runs leave the prediction without the effect uncertain; 100 runs with the effect at
    // one state, each with an error of 0.003 or so, determine the sum of prediction and response
    // there to about 0.0003. The response alone remains as uncertain as the prediction without.
    auto runs = invented_runs(8, 1);
    const FlowState plain{0.3, 0.01};
    FlowState with_it = plain;
    with_it.effects = {{"dry-adhesion", {0.2}}};
    constexpr double change = 0.3;
    std::mt19937_64 random(3);
    std::normal_distribution<double> error(0, 0.002);
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        dem::RunResult run = runs.front();
        run.parameters.wetting.reset();
        run.parameters.friction = plain.friction;
        run.parameters.inertial_number = plain.inertial_number;
        run.parameters.effects = with_it.effects;
        run.parameters.seed = 1000 + seed;
        run.means[static_cast<std::size_t>(Observable::stress_ratio)].value =
            InventedLaw::stress_ratio(plain) + change + error(random);
        runs.push_back(run);
    }
    const Emulator emulator(runs, shipped_hyperparameters());
    const std::vector<Query> both = {{with_it, Observable::stress_ratio},
                                     {plain, Observable::stress_ratio}};
    const Eigen::MatrixXd covariance = emulator.covariance(both);
    const double with_error = std::sqrt(covariance(0, 0)),
                 without_error = std::sqrt(covariance(1, 1));
    EXPECT_GT(without_error, 0.003);
    EXPECT_LT(with_error, 0.5 * without_error);
    EXPECT_NEAR(emulator.mean(both)(0), InventedLaw::stress_ratio(plain) + change, 4 * with_error);
    const double change_error =
        std::sqrt(covariance(0, 0) + covariance(1, 1) - 2 * covariance(0, 1));
    EXPECT_NEAR(change_error, without_error, 0.5 * without_error);
}

/// Rolling resistance is felt as far as friction lets it be: of 72 runs with it, of frictions from
/// 0.05 to 0.5, a third is foretold from the others to 0.006 RMS; their own errors are 0.005 to
/// 0.010. A response in proportion to the coefficient is off by 0.011, or 0.016 in other thirds.
TEST(Emulator, ForetellsRollingResistanceAtOtherFrictions) {
    std::vector<dem::RunResult> known, others;
    for (const auto& run : all_shipped_runs()) {
        const auto& effects = run.parameters.effects;
        const bool rolling = effects.size() == 1 && effects[0].effect == "rolling-resistance";
        (rolling && (known.size() + others.size()) % 3 == 0 ? others : known).push_back(run);
    }
    ASSERT_GT(others.size(), 20u);
    const Emulator emulator(known, shipped_hyperparameters());
    double squares = 0;
    for (const auto& run : others) {
        const double said =
            emulator.mean({{emulated::flow_state_of(run.parameters), Observable::stress_ratio}})(0);
        squares += std::pow(said - run[Observable::stress_ratio].value, 2);
    }
    EXPECT_LT(std::sqrt(squares / static_cast<double>(others.size())), 0.009);
}

/// Relative change of the stress ratio by a switch that only wet beads feel, at friction 0.09 and
/// inertial number 0.03.
double wet_change(const std::string& effect, double reduced_pressure, double bridge_volume) {
    static const Emulator emulator(all_shipped_runs(), shipped_hyperparameters());
    const FlowState plain{0.09, 0.03, 1 / reduced_pressure, bridge_volume};
    FlowState with_it = plain;
    with_it.effects = {{effect, {1}}};
    const Eigen::VectorXd said =
        emulator.mean({{plain, Observable::stress_ratio}, {with_it, Observable::stress_ratio}});
    return said(1) / said(0) - 1;
}

TEST(Emulator, LetsEffectsOnWetBeadsFadeWithCapillarity) {
    for (const char* effect : {"willett-bridges", "reversible-bridges", "capillary-coulomb"}) {
        const double strong = wet_change(effect, 2, 0.004), weak = wet_change(effect, 100, 0.004);
        EXPECT_GT(std::abs(strong), 0.01) << effect;
        EXPECT_LT(std::abs(weak), 0.1 * std::abs(strong)) << effect;
    }
    // Against four runs of other seeds, each within 0.3 %, at P* 2.32: 0.4184, 0.4179 without,
    // 0.4073, 0.4076 with.
    EXPECT_NEAR(wet_change("willett-bridges", 2.32, 0.00385), 0.40745 / 0.41815 - 1, 0.006);
}

// A flow in a band is not the flow that an emulator of uniform shear interpolates.
TEST(Emulator, LearnsNothingOfRunsThatShearInABand) {
    dem::RunResult run = shipped_runs().front();
    ASSERT_TRUE(emulated::usable(run));
    Mean& localization = run.means[static_cast<std::size_t>(Observable::localization)];
    localization.value = 0.3;
    EXPECT_EQ(emulated::why_unusable(run), "sheared in a band");
    EXPECT_FALSE(emulated::usable(run));
    localization.value = 0.15;
    EXPECT_TRUE(emulated::usable(run)) << "small samples at low pressures";
    run.parameters.stiffness_number = 100;
    EXPECT_EQ(emulated::why_unusable(run), "has a stiffness number below 300");
    for (const dem::RunResult& shipped : shipped_runs()) {
        EXPECT_LT(shipped[Observable::localization].value, emulated::banded_above);
    }
}

TEST(Emulator, NamesAnEffectThatNoRunHas) {
    const Emulator emulator(invented_runs(60, 1), shipped_hyperparameters());
    FlowState state{0.1, 0.01};
    state.effects = {{"rolling-resistance", {0.1}}};
    try {
        emulator.mean({{state, Observable::stress_ratio}});
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what())
                      .find("no simulation in atlas and store has the effect rolling-resistance"),
                  std::string::npos)
            << error.what();
    }
}

TEST(Emulator, IsNotTrainedByRunsWithValuesThatOnlySimulationsHave) {
    const auto with_run_of = [](std::vector<double> values) {
        auto runs = invented_runs(60, 1);
        runs.push_back(runs.front());
        runs.back().parameters.effects = {{"unequal-bridges", std::move(values)}};
        return Emulator(runs, shipped_hyperparameters());
    };
    EXPECT_TRUE(with_run_of({0.5, 0}).knows("unequal-bridges"));
    EXPECT_FALSE(with_run_of({0.5, 3}).knows("unequal-bridges"));  // bridges exchange liquid
    EXPECT_FALSE(with_run_of({0.5, 0}).knows("rolling-resistance"));
}

TEST(Kernel, HasTheGradientOfItsLikelihood) {
    const auto runs = invented_runs(60, 1);
    Observations known;
    known.values.resize(60, 1);
    for (std::size_t k = 0; k < runs.size(); ++k) {
        known.at.push_back(coordinates(emulated::flow_state_of(runs[k].parameters), 0.1, 0.5));
        known.values(static_cast<Eigen::Index>(k), 0) = runs[k][Observable::stress_ratio].value;
        known.noise.push_back(Eigen::MatrixXd::Constant(1, 1, 4e-6));
    }
    const Hyperparameters at{0.05, 0.8, 0.3, 0.07, 1.2, 0.4, 1.5, 2.5, 1.3, 2e-3};
    std::array<double, Hyperparameters::count> gradient{}, none{};
    hyperparameter_cost(Domain::all_flow, known, 0.5, at, gradient.data());
    for (std::size_t k = 0; k < Hyperparameters::count; ++k) {
        constexpr double step = 1e-4;
        const auto cost = [&](double by) {
            auto hyperparameters = at.as_array();
            hyperparameters[k] *= std::exp(by);
            return hyperparameter_cost(Domain::all_flow, known, 0.5,
                                       Hyperparameters::from_array(hyperparameters), nullptr);
        };
        const double difference = (cost(step) - cost(-step)) / (2 * step);
        EXPECT_NEAR(gradient[k], difference, 1e-3 * (1 + std::abs(difference)))
            << Hyperparameters::names[k];
    }
    // And the learned hyperparameters are where it vanishes.
    const Hyperparameters best = fit_hyperparameters(Domain::all_flow, known, 0.5);
    hyperparameter_cost(Domain::all_flow, known, 0.5, best, none.data());
    EXPECT_THAT(none, testing::Each(testing::DoubleNear(0, 0.1)));
}

TEST(Emulator, FindsALawFromNoisyRuns) {
    const Emulator emulator(invented_runs(150, 2), {});
    double ratio2 = 0, solid2 = 0;
    const auto fresh = invented_runs(200, 77);
    for (const auto& run : fresh) {
        const FlowState state = emulated::flow_state_of(run.parameters);
        const std::vector<Query> both = {{state, Observable::stress_ratio},
                                         {state, Observable::solid_fraction}};
        const Eigen::VectorXd mean = emulator.mean(both);
        const Eigen::MatrixXd covariance = emulator.covariance(both);
        ratio2 += std::pow(mean(0) - InventedLaw::stress_ratio(state), 2) / covariance(0, 0);
        solid2 += std::pow(mean(1) - InventedLaw::solid_fraction(state), 2) / covariance(1, 1);
    }
    // The errors of one emulator go together: 200 of them are some tens of independent ones.
    EXPECT_GT(ratio2 / 200, 0.4);
    EXPECT_LT(ratio2 / 200, 2.0);
    EXPECT_GT(solid2 / 200, 0.4);
    EXPECT_LT(solid2 / 200, 2.0);
}

TEST(Emulator, KeepsTheCorrelationOfItsRuns) {
    const Emulator emulator(invented_runs(100, 3), {});
    const FlowState state{0.3, 0.01, 0.5, 0.002};
    const Eigen::MatrixXd covariance = emulator.covariance(
        {{state, Observable::stress_ratio}, {state, Observable::solid_fraction}});
    const double correlation = covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1));
    EXPECT_LT(correlation, -0.1);  // that of the runs is -0.5
    EXPECT_GT(correlation, -0.9);
}

TEST(Emulator, HasThePhysicalLimits) {
    const Emulator& emulator = shipped();
    const FlowState dry{0.2, 0.01};
    // Where there is no liquid its volume is of no matter, to the last bit.
    FlowState other = dry;
    other.bridge_volume = 0.005;
    for (const Observable which : {Observable::stress_ratio, Observable::solid_fraction}) {
        EXPECT_EQ(emulator.mean({{dry, which}})(0), emulator.mean({{other, which}})(0));
        EXPECT_EQ(emulator.mean({{dry, which, Input::bridge_volume}})(0), 0);
        // Capillarity goes out with 1/P*.
        const FlowState weak{0.2, 0.01, 1e-9, 0.005};
        EXPECT_NEAR(emulator.mean({{weak, which}})(0), emulator.mean({{dry, which}})(0), 1e-8);
    }
    // The quasi-static limit is finite and close below.
    const double limit = emulator.mean({{{0.2, 0}, Observable::stress_ratio}})(0),
                 slow = emulator.mean({{{0.2, 1e-3}, Observable::stress_ratio}})(0);
    EXPECT_NEAR(limit, slow, 0.01);
    EXPECT_THROW(emulator.mean({{dry, Observable::distant_force}}), std::invalid_argument);
}

TEST(Emulator, HasDerivativesOfItsOwnPredictions) {
    const Emulator& emulator = shipped();
    for (const FlowState& state :
         {FlowState{0.1, 0.01, 1, 0.002}, FlowState{0.4, 0.003, 0.1, 0.006}}) {
        for (const Observable which :
             {Observable::stress_ratio, Observable::solid_fraction, Observable::distant_force,
              Observable::capillary_shear_stress, Observable::contact_coordination}) {
            for (const Input input : {Input::friction, Input::log_inertial_number,
                                      Input::inverse_pressure, Input::bridge_volume}) {
                const double step = input == Input::bridge_volume ? 1e-5 : 1e-4;
                const auto value = [&](double by) {
                    return emulator.mean({{moved(state, input, by), which}})(0);
                };
                const double difference =
                    (8 * (value(step) - value(-step)) - (value(2 * step) - value(-2 * step))) /
                    (12 * step);
                const double slope = emulator.mean({{state, which, input}})(0);
                EXPECT_NEAR(slope, difference, 1e-6 * std::max(1.0, std::abs(difference)))
                    << static_cast<int>(which) << ' ' << static_cast<int>(input);
            }
        }
    }
}

TEST(Emulator, HasTheCovarianceOfItsDerivatives) {
    // That of a difference quotient, from the covariance of the two values.
    const Emulator& emulator = shipped();
    const FlowState state{0.1, 0.01, 1, 0.002};
    for (const Input input : {Input::friction, Input::log_inertial_number, Input::inverse_pressure,
                              Input::bridge_volume}) {
        const double step = input == Input::bridge_volume ? 2e-5 : 1e-2;
        const Eigen::MatrixXd c =
            emulator.covariance({{moved(state, input, step), Observable::stress_ratio},
                                 {moved(state, input, -step), Observable::stress_ratio},
                                 {state, Observable::stress_ratio, input},
                                 {state, Observable::stress_ratio}});
        const double variance = (c(0, 0) + c(1, 1) - 2 * c(0, 1)) / (4 * step * step);
        EXPECT_NEAR(c(2, 2), variance, 0.02 * variance);
        EXPECT_NEAR(c(2, 3), (c(0, 3) - c(1, 3)) / (2 * step), 0.02 * std::sqrt(c(2, 2) * c(3, 3)));
    }
}

TEST(Emulator, SaysWhatLiesBeyondItsRuns) {
    EXPECT_EQ(shipped().beyond({0.3, 0.01, 1, 0.002}), "");
    EXPECT_EQ(shipped().beyond({0.3, 0}), "");  // extrapolated to the limit, with its error
    expect_told({shipped().beyond({0.8, 0.01}), shipped().beyond({0.3, 0.2}),
                 shipped().beyond({0.3, 0.01, 5, 0.02})});
    // And grows unsure there.
    const auto error = [](const FlowState& state) {
        return std::sqrt(shipped().covariance({{state, Observable::stress_ratio}})(0, 0));
    };
    EXPECT_GT(error({0.3, 0.01, 8, 0.02}), 4 * error({0.3, 0.01, 1.5, 0.004}));
}

TEST(Emulator, TurnsALiquidContentIntoABridgeVolume) {
    for (const double content : {0.004, 0.014, 0.05}) {
        FlowState state{0.09, 0.003, 1.0 / 3};
        state.bridge_volume = bridge_volume_of(shipped(), content, state);
        EXPECT_NEAR(dem::liquid_content(state.bridge_volume, coordination(shipped(), state).value),
                    content, 1e-9);
        // Runs measure the content themselves; the two emulators must agree.
        EXPECT_NEAR(shipped().mean({{state, Observable::liquid_content}})(0), content,
                    0.02 * content);
    }
}

TEST(Emulator, LeavesOutRunsThatTellNothingTrue) {
    auto runs = invented_runs(40, 5);
    runs[0].crystallised = true;
    runs[1].steady = false;
    runs[2].failure = "it fell";
    runs[3].parameters.damping = 0.5;
    EXPECT_EQ(Emulator(runs, {}).runs().size(), 36u);
    EXPECT_THROW(Emulator({runs[0], runs[1]}, {}), std::invalid_argument);
}

TEST(Emulator, BringsRunsOfAnyStiffnessTogether) {
    // Solid fractions of softer beads, whose overlap shows it, say the same of rigid ones.
    auto runs = invented_runs(120, 6);
    for (std::size_t k = 0; k < runs.size(); k += 3) {
        auto& run = runs[k];
        run.parameters.stiffness_number = 500;
        auto &overlap = run.means[static_cast<std::size_t>(Observable::overlap)],
             &solid = run.means[static_cast<std::size_t>(Observable::solid_fraction)];
        overlap.value = 0.002;
        solid.value += dem::rigidity_shift(solid.value, 0.001);
    }
    const Emulator emulator(runs, {});
    const FlowState state{0.3, 0.01};
    const auto at = [&](double stiffness) {
        return emulated_at(emulator, state, stiffness,
                           {Observable::solid_fraction, Observable::overlap});
    };
    const double rigid = InventedLaw::solid_fraction(state);
    EXPECT_NEAR(at(1e9)[0].value.value, rigid, 0.0006);
    EXPECT_NEAR(at(1000)[0].value.value, rigid + dem::rigidity_shift(rigid, 0.001), 0.0006);
    EXPECT_NEAR(at(500)[1].value.value, 0.002, 2e-5);
    // Rigid beads carry the error of the correction as well.
    EXPECT_GT(at(1e9)[0].value.standard_error, at(1000)[0].value.standard_error);
    const double step = 1e-4;
    const auto solid_at = [&](double friction) {
        return emulated_at(emulator, {friction, 0.01}, 2000, {Observable::solid_fraction})[0]
            .value.value;
    };
    EXPECT_NEAR(emulated_at(emulator, state, 2000, {Observable::solid_fraction})[0].slopes[0].value,
                (solid_at(0.3 + step) - solid_at(0.3 - step)) / (2 * step), 1e-5);
}

TEST(EmulatorHyperparameters, AreThoseThatTheAtlasTeaches) {
    const auto runs = shipped_runs();
    const auto shipped_ones = shipped_hyperparameters();
    EXPECT_EQ(shipped_ones.size(), emulated::observables().size());
    const Hyperparameters learned = PlainEmulator::learn(runs, Observable::stress_ratio);
    const auto a = learned.as_array(), b = shipped_ones.at(Observable::stress_ratio).as_array();
    for (std::size_t k = 0; k < Hyperparameters::count; ++k) {
        EXPECT_NEAR(std::log(a[k] / b[k]), 0, 0.1) << Hyperparameters::names[k];
    }
}

TEST(EmulatorHyperparameters, AreReadBackAndCheckedCellByCell) {
    const TemporaryFolder folder;
    const EmulatorHyperparameters hyperparameters = {
        {Observable::stress_ratio, {.dry_x = 0.7, .noise = 1.5}}};
    write_hyperparameters(folder.path() / "scales.csv", hyperparameters);
    EXPECT_EQ(read_hyperparameters(folder.path() / "scales.csv").at(Observable::stress_ratio).dry_x,
              0.7);
    std::string header = "observable";
    for (const auto name : Hyperparameters::names) {
        header += "," + std::string(name);
    }
    const auto refusal = [&](const std::string& text) {
        return input_error([&] { read_hyperparameters(folder.write("bad.csv", text)); });
    };
    expect_told({refusal(header + "\nstress_ratio,1,1,1,1,-1,1,1,1,1,1\n"),
                 refusal(header + "\nstres_ratio,1,1,1,1,1,1,1,1,1,1\n"),
                 refusal("observable,noise\nstress_ratio,1\n")});
}

}  // namespace pendular::calib_emulator_test
