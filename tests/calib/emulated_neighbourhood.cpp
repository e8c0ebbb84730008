// Expansions of the emulator for difference quotients, against predictions made anew.
#include "calib/model/emulated_neighbourhood.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/emulator_support.h"

namespace pendular::calib_emulated_neighbourhood_test {

EffectiveCondition condition(double stress, double inertial_number, double content) {
    return Condition{
        .normal_stress = stress, .inertial_number = inertial_number, .liquid_content = content};
}

Eigen::VectorXd at(double friction) {
    return Eigen::VectorXd::Constant(1, friction);
}

class EmulatedNeighbourhoodTest : public testing::Test {
  protected:
    EmulatedSimulation model{stiff_wet_study(), fidelity_named("quick"),
                             Emulator(all_shipped_runs(), shipped_hyperparameters())};
    std::vector<EffectiveCondition> conditions = {condition(1000, 0.01, 0), condition(300, 0, 0),
                                                  condition(300, 0.003, 0.03),
                                                  condition(600, 0.01, 0.007)};
    static constexpr double friction = 0.15;

    /// Central difference of the predictions where `move` changes friction and conditions by steps
    /// of both signs.
    template <typename Values, typename Move>
    static Eigen::VectorXd difference(const Values& values, const Move& move, double step) {
        return (values(move(step)) - values(move(-step))) / (2 * step);
    }

    /// Compares the differences of the expansion with those of predictions made anew.
    template <typename Move>
    void expect_same_slopes(const Move& change) const {
        struct Moved {
            double friction;
            std::vector<EffectiveCondition> conditions;
        };
        const auto move = [&](double step) {
            Moved moved{friction, conditions};
            for (EffectiveCondition& each : moved.conditions) {
                change(step, moved.friction, each);
            }
            return moved;
        };
        const auto nearby = model.neighbourhood(at(friction), conditions);
        const auto expanded = [&](const Moved& there) {
            return nearby->values(at(there.friction), there.conditions, {0, 1, 2, 3});
        };
        const auto anew = [&](const Moved& there) {
            return model.predict_flow(at(there.friction), there.conditions, PredictionPart::values)
                .value;
        };
        const Eigen::VectorXd slopes = difference(expanded, move, 1e-5),
                              expected = difference(anew, move, 2e-3);
        for (Eigen::Index k = 0; k < slopes.size(); ++k) {
            // The step of the predictions made anew leaves an error of second order.
            EXPECT_NEAR(slopes(k), expected(k), 1e-3 * (std::abs(expected(k)) + 1e-3)) << k;
        }
    }
};

TEST_F(EmulatedNeighbourhoodTest, HasTheValuesOfTheSimulation) {
    const Eigen::VectorXd expected =
        model.predict_flow(at(friction), conditions, PredictionPart::values).value;
    const Eigen::VectorXd values = model.neighbourhood(at(friction), conditions)
                                       ->values(at(friction), conditions, {0, 1, 2, 3});
    EXPECT_LT((values - expected).cwiseAbs().cwiseQuotient(expected).maxCoeff(), 1e-7);
}

TEST_F(EmulatedNeighbourhoodTest, HasTheSlopesOfTheSimulation) {
    const auto scale = [](double step, double& value) { value *= 1 + step; };
    expect_same_slopes(
        [&](double step, double&, EffectiveCondition& c) { scale(step, c.normal_stress); });
    expect_same_slopes(
        [&](double step, double&, EffectiveCondition& c) { scale(step, c.inertial_number); });
    expect_same_slopes(
        [&](double step, double&, EffectiveCondition& c) { scale(step, c.liquid_content); });
    expect_same_slopes(
        [&](double step, double&, EffectiveCondition& c) { c.friction_difference += 0.1 * step; });
}

TEST_F(EmulatedNeighbourhoodTest, HasTheSlopesByEffectsOnGrains) {
    for (EffectiveCondition& each : conditions) {
        each.grain_effects = {{"rolling-resistance", {0.1}}, {"polydispersity", {0.1}}};
    }
    expect_same_slopes([](double step, double&, EffectiveCondition& c) {
        c.grain_effects[0].values[0] *= 1 + step;
    });
    expect_same_slopes([](double step, double&, EffectiveCondition& c) {
        c.grain_effects[1].values[0] *= 1 + step;
    });
    expect_same_slopes(
        [](double step, double&, EffectiveCondition& c) { c.friction_difference += 0.1 * step; });
    expect_same_slopes(
        [](double step, double&, EffectiveCondition& c) { c.normal_stress *= 1 + step; });
}

TEST_F(EmulatedNeighbourhoodTest, PredictsAnewWhereAConditionBecomesDry) {
    const auto nearby = model.neighbourhood(at(friction), conditions);
    std::vector<EffectiveCondition> dried = {conditions[2]};
    dried[0].liquid_content = 0;
    const Eigen::VectorXd expected =
        model.predict_flow(at(friction), dried, PredictionPart::values).value;
    EXPECT_EQ(nearby->values(at(friction), dried, {2}), expected);
}

}  // namespace pendular::calib_emulated_neighbourhood_test
