// Changes that no known effect makes: the diagnosis names their shape.
#include "analysis/proposals/propose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "reports/proposal_report.h"
#include "tests/physics/planted_readings.h"

namespace pendular {
namespace {

/// Effect on the instrument that the program does not know, at full size.
template <typename Show>
Effect unknown_effect(Show show) {
    return {.name = "unknown",
            .summary = "hidden",
            .parameters = {on_switch("hidden")},
            .change = ChangeInstrument{
                .show = [show](CellState shown, const Values&) { return show(shown); },
                .where = ChangeInstrument::Where::transducers}};
}

/// Proposals for readings of the laboratory with a hidden effect and random errors.
std::vector<Proposal> proposals_for(const Effect& hidden, std::uint64_t seed) {
    const std::vector<Effect> more = {hidden};
    const StudyModels with_hidden = models().offering(more);
    const std::shared_ptr<const Model> truth = with_hidden.with({models().candidates().size()});
    const Eigen::VectorXd parameters = Eigen::VectorXd::Constant(1, planted_friction);
    std::mt19937_64 random(seed);
    const auto readings =
        scattered(conditions(), truth->predict(parameters, PredictionPart::values).value, random);
    const Evidence evidence = evidence_of(readings, {});
    const DiagnosisOptions options;
    const Diagnosis diagnosis = diagnose(models(), evidence, options);
    EXPECT_FALSE(diagnosis.complete);
    return propose(planted_study(), models(), evidence, readings, diagnosis, options);
}

TEST(Proposals, NameADragThatGrowsWithSpeed) {
    const double drag = 4e-4;  // [N m s/rad]
    const auto proposals = proposals_for(unknown_effect([&](CellState s) {
                                             s.torque += drag * s.angular_velocity;
                                             return s;
                                         }),
                                         11);
    ASSERT_FALSE(proposals.empty());
    ASSERT_EQ(proposals[0].shapes.size(), 1u);
    const auto& [shape, effect, change, error] = proposals[0].shapes[0];
    EXPECT_TRUE(proposals[0].fits());
    EXPECT_LT(proposals[0].p, 0.001);
    EXPECT_EQ(shape.name(), "torque-with-angular-velocity");
    EXPECT_EQ(shape.profile.constant, 1);
    EXPECT_FALSE(shape.quantity.relative);
    EXPECT_NEAR(change, drag * shape.profile.full_at, 4 * error);
    EXPECT_LT(error, 0.1 * std::abs(change));
}

TEST(Proposals, NameAStepInTime) {
    const double at = 500;  // [s]
    const auto proposals = proposals_for(unknown_effect([&](CellState s) {
                                             if (s.time > at) s.torque *= 1.1;
                                             return s;
                                         }),
                                         12);
    ASSERT_FALSE(proposals.empty());
    ASSERT_EQ(proposals[0].shapes.size(), 1u);
    const auto& [shape, effect, change, error] = proposals[0].shapes[0];
    EXPECT_TRUE(proposals[0].fits());
    EXPECT_EQ(shape.profile.dependence, Dependence::above);
    EXPECT_EQ(shape.profile.variable, "time");
    EXPECT_NEAR(shape.profile.constant, at, 30);
    EXPECT_NEAR(change, 0.1, 4 * error);
    EXPECT_NE(sentence_on(proposals[0]).find("% larger than in the model where the time"),
              std::string::npos);
}

TEST(Proposals, NameASaturation) {
    const double linear_up_to = 5;  // [N]
    const auto proposals = proposals_for(unknown_effect([&](CellState s) {
                                             s.normal_force -=
                                                 0.2 * std::max(0.0, s.normal_force - linear_up_to);
                                             return s;
                                         }),
                                         13);
    ASSERT_FALSE(proposals.empty());
    EXPECT_TRUE(proposals[0].fits());
    // The torque over the force shows the ratio alone, so that either may be at fault.
    std::vector<FittedShape> named = proposals[0].alike;
    named.push_back(proposals[0].shapes[0]);
    const auto force = std::ranges::find_if(named, [](const FittedShape& each) {
        return each.shape.quantity.target == "normal_force";
    });
    ASSERT_NE(force, named.end());
    EXPECT_EQ(force->shape.profile.variable, "normal_stress");
    EXPECT_LT(force->change, 0);
}

TEST(Proposals, NameAnOscillation) {
    const double period = 130;  // [s]
    const auto proposals = proposals_for(
        unknown_effect([&](CellState s) {
            s.torque *= 1 + 0.08 * std::sin(2 * std::numbers::pi * s.time / period + 0.4);
            return s;
        }),
        14);
    ASSERT_FALSE(proposals.empty());
    EXPECT_TRUE(proposals[0].fits());
    const auto& [shape, effect, change, error] = proposals[0].shapes[0];
    EXPECT_EQ(shape.profile.dependence, Dependence::oscillation);
    EXPECT_NEAR(shape.profile.constant, period, 5);
    EXPECT_NEAR(std::abs(change), 0.08, 4 * error);
}

}  // namespace
}  // namespace pendular
