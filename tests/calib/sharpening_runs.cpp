// Which runs sharpen fitted models: those at the readings' own states.
#include "calib/fit/sharpening_runs.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "calib/model/effect_model.h"
#include "tests/support/emulator_support.h"

namespace pendular::calib_sharpening_runs_test {

TEST(SharpeningRuns, AreAtTheStatesOfTheReadingsWithAndWithoutEffects) {
    Study study;
    study.grains = {.diameter = 500e-6, .density = 1050, .youngs_modulus = 3.3e9};
    const auto simulation = std::make_shared<const EmulatedSimulation>(
        study, fidelity_named("quick"), Emulator(all_shipped_runs(), shipped_hyperparameters()));
    const auto model = std::make_shared<const EffectModel>(
        simulation, study, std::vector<const Effect*>{&built_in_effect("rolling-resistance")});
    // Two readings at one state, one slower than any run: two states.
    std::vector<Reading> readings(3);
    for (Reading& reading : readings) {
        reading.condition = {.normal_stress = 1000, .inertial_number = 0.03};
        reading.covariance.diagonal() << 100, 1e-6;  // 1 % of the stress, 0.001
    }
    readings[2].condition.inertial_number = 1e-4;
    // Friction and coefficient are known worst along their difference: both move by their errors.
    Eigen::Matrix2d covariance;
    covariance << 9e-4, -8.1e-4, -8.1e-4, 9e-4;
    const RunChoice choice = sharpening_choice(
        *simulation,
        {{.predictor = model,
          .fit = {.parameters = Eigen::Vector2d(0.4, 0.2), .covariance = covariance}}},
        readings, 0.003);
    ASSERT_EQ(choice.targets.size(), 6u);
    EXPECT_EQ(choice.from.size(), 12u);
    std::vector<double> frictions, coefficients;
    for (std::size_t k = 0; k < choice.targets.size(); ++k) {
        const FlowState& state = choice.targets[k];
        ASSERT_EQ(state.effects.size(), 1u);
        frictions.push_back(state.friction);
        coefficients.push_back(state.effects[0].values[0]);
        EXPECT_GE(state.inertial_number, 0.003);
        // Weights are sums of 1/0.01^2 and 1/0.001^2 over the readings at a state.
        const double count = state.inertial_number > 0.01 ? 2 : 1;
        EXPECT_NEAR(choice.weights(2 * static_cast<Eigen::Index>(k)), count * 1e4, 1);
        EXPECT_NEAR(choice.weights(2 * static_cast<Eigen::Index>(k) + 1), count * 1e6, 1);
    }
    // sqrt(1.9/2) of a standard error of 0.03 each, in opposite directions.
    const auto widest = std::ranges::max_element(frictions) - frictions.begin();
    EXPECT_NEAR(frictions[static_cast<std::size_t>(widest)], 0.4 + 0.0292, 1e-4);
    EXPECT_NEAR(coefficients[static_cast<std::size_t>(widest)], 0.2 - 0.0292, 1e-4);
    EXPECT_EQ(
        std::ranges::count_if(choice.from, [](const FlowState& s) { return s.effects.empty(); }),
        6);
}

}  // namespace pendular::calib_sharpening_runs_test
