// Predictions at stiffness numbers other than that of most training runs.
#include <gtest/gtest.h>

#include <cmath>

#include "calib/emulator/emulated_state.h"
#include "tests/support/emulator_support.h"

namespace pendular::stiffness_test {

using dem::Observable;

constexpr double stiff = 8400;

bool is_stiff(const dem::RunResult& run) {
    return run.parameters.stiffness_number > 2000;
}

/// Wet state at which the atlas has a run at stiffness number 8400.
bool at_state(const dem::RunResult& run) {
    const dem::RunParameters& p = run.parameters;
    return is_stiff(run) && p.friction == 0.09 && p.wetting && p.wetting->reduced_pressure == 1 &&
           p.wetting->bridge_volume == 0.001;
}

/// Emulated value at the state of a run, for its stiffness number.
Estimate emulated(const Emulator& emulator, const dem::RunResult& run, Observable which) {
    return emulated_at(emulator, emulated::flow_state_of(run.parameters),
                       run.parameters.stiffness_number, {which})[0]
        .value;
}

TEST(Stiffness, ChangesPredictionsAsRunsThatWereLeftOut) {
    std::vector<dem::RunResult> training = shipped_runs();
    const auto found = std::ranges::find_if(training, at_state);
    ASSERT_NE(found, training.end());
    const dem::RunResult run = *found;
    std::erase_if(training, at_state);
    const Emulator emulator(training, shipped_hyperparameters());
    std::erase_if(training, is_stiff);
    const Emulator unknowing(training, shipped_hyperparameters());
    EXPECT_TRUE(emulator.knows_stiffness());
    EXPECT_FALSE(unknowing.knows_stiffness());
    for (const Observable which :
         {Observable::distant_coordination, Observable::contact_force, Observable::distant_force,
          Observable::fabric_12_contact, Observable::stress_ratio}) {
        const Estimate predicted = emulated(emulator, run, which);
        const double error =
            std::hypot(predicted.standard_error, std::sqrt(emulator.noise_variance(run, which)));
        EXPECT_NEAR(predicted.value, run[which].value, 3 * error)
            << dem::observable_names[static_cast<std::size_t>(which)];
    }
    // Without runs of other stiffness numbers, Z_d would be that of soft grains.
    EXPECT_LT(emulated(unknowing, run, Observable::distant_coordination).value,
              0.9 * run[Observable::distant_coordination].value);
}

TEST(Stiffness, OfTheStateHasNoInfluence) {
    const auto runs = shipped_runs();
    const auto stiff_run = std::ranges::find_if(runs, at_state);
    ASSERT_NE(stiff_run, runs.end());
    const Emulator emulator(runs, shipped_hyperparameters());
    FlowState state = emulated::flow_state_of(stiff_run->parameters);
    const auto fraction_of = [&] {
        return emulated_at(emulator, state, stiff, {Observable::solid_fraction})[0].value.value;
    };
    state.stiffness_number = stiff;
    const double of_stiff = fraction_of();
    state.stiffness_number = 0;
    EXPECT_EQ(fraction_of(), of_stiff);
}

TEST(Stiffness, ChangesNothingAtThatOfTheTrainingRuns) {
    std::vector<dem::RunResult> soft = shipped_runs();
    std::erase_if(soft, is_stiff);
    const Emulator emulator(shipped_runs(), shipped_hyperparameters()),
        unknowing(soft, shipped_hyperparameters());
    FlowState state{0.15, 0.01, 0.7, 0.002};
    for (const double stiffness_number : {0.0, 1000.0}) {
        state.stiffness_number = stiffness_number;
        const std::vector<Query> queries = {{state, Observable::stress_ratio},
                                            {state, Observable::distant_coordination}};
        EXPECT_EQ(emulator.mean(queries), unknowing.mean(queries));
        EXPECT_EQ(emulator.covariance(queries), unknowing.covariance(queries));
    }
}

TEST(Stiffness, HasDerivativesOfItsPredictions) {
    const Emulator emulator(shipped_runs(), shipped_hyperparameters());
    FlowState state{0.15, 0.01, 0.7, 0.002};
    state.stiffness_number = stiff;
    for (const Observable which : {Observable::stress_ratio, Observable::distant_coordination}) {
        const auto value = [&](const FlowState& at) { return emulator.mean({{at, which}})(0); };
        const Eigen::VectorXd slopes = emulator.mean({{state, which, Input::friction},
                                                      {state, which, Input::log_inertial_number},
                                                      {state, which, Input::inverse_pressure},
                                                      {state, which, Input::bridge_volume}});
        double FlowState::*const variables[] = {&FlowState::friction, &FlowState::inertial_number,
                                                &FlowState::inverse_pressure,
                                                &FlowState::bridge_volume};
        for (Eigen::Index k = 0; k < 4; ++k) {
            double FlowState::*const variable = variables[k];
            const double step = 1e-4 * state.*variable;
            FlowState above = state, below = state;
            above.*variable += step, below.*variable -= step;
            const double unit = k == 1 ? state.inertial_number : 1;
            const double expected = unit * (value(above) - value(below)) / (2 * step);
            EXPECT_NEAR(slopes(k), expected, 1e-4 * std::abs(expected)) << k;
        }
    }
}

/// Runs of another stiffness number alone: they train the emulator at their own.
TEST(Stiffness, IsThatOfTheRunsWhereNoneHasTheUsualOne) {
    std::vector<dem::RunResult> runs = invented_runs(40, 3);
    for (dem::RunResult& run : runs) {
        run.parameters.stiffness_number = stiff;
    }
    const Emulator emulator(runs, {});
    EXPECT_FALSE(emulator.knows_stiffness());
    EXPECT_NEAR(emulator.mean({{FlowState{0.3, 0.01}, Observable::stress_ratio}})(0),
                InventedLaw::stress_ratio({0.3, 0.01}), 0.01);
}

}  // namespace pendular::stiffness_test
