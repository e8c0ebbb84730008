// Laws of effects that change what a state of flow shows.
#include <cmath>
#include <variant>

#include "registered_effects.h"

namespace flow_effects_test {

using namespace pendular;

class FlowEffects : public EveryEffect {
  protected:
    FlowPoint changed(const FlowPoint& point, const std::vector<double>& values) const {
        return std::get<ChangeFlow>(effect().change)
            .change(point, Condition{.normal_stress = 1000, .at_failure = true},
                    Values(effect().parameters, values));
    }
};

const std::vector<FlowPoint> points = {{0.25, 0.6}, {0.4, 0.55}, {1.2, 0.5}};

TEST_P(FlowEffects, VanishesAtItsNeutralValue) {
    for (const FlowPoint& point : points) {
        const FlowPoint same = changed(point, effect().neutral());
        EXPECT_EQ(same.stress_ratio, point.stress_ratio);
        EXPECT_EQ(same.solid_fraction, point.solid_fraction);
    }
}

TEST_P(FlowEffects, ChangesSomethingAtTheSizeThatMatters) {
    for (const auto& values : values_that_matter(effect()))
        for (const FlowPoint& point : points) {
            const FlowPoint other = changed(point, values);
            EXPECT_GT(std::abs(other.stress_ratio / point.stress_ratio - 1) +
                          std::abs(other.solid_fraction / point.solid_fraction - 1),
                      1e-3);
        }
}

TEST_P(FlowEffects, IsPositiveAtTheCornersOfItsBounds) {
    for (const auto& corner : corners(effect()))
        for (const FlowPoint& point : points) {
            EXPECT_GT(changed(point, corner).stress_ratio, 0);
            EXPECT_GT(changed(point, corner).solid_fraction, 0);
        }
}

TEST_P(FlowEffects, GrowsWithTheStressRatio) {
    for (const auto& corner : corners(effect()))
        EXPECT_LT(changed(points[0], corner).stress_ratio, changed(points[1], corner).stress_ratio);
}

INSTANTIATE_TEST_SUITE_P(Effects, FlowEffects,
                         testing::ValuesIn(names_of_effects([](const Effect& e) {
                             return std::holds_alternative<ChangeFlow>(e.change);
                         })),
                         test_name);

TEST(EffectsAtFailure, TouchNoSteadyShear) {
    int found = 0;
    for (const Effect& effect : built_in_effects()) {
        if (effect.touches != Touches::failure) continue;
        ++found;
        for (const double content : {0.0, 0.02}) {
            Condition condition{.normal_stress = 1000, .liquid_content = content};
            EXPECT_TRUE(touching({{&effect, effect.neutral()}}, condition).empty());
            condition.at_failure = true;
            EXPECT_EQ(touching({{&effect, effect.neutral()}}, condition).size(), 1u);
        }
    }
    EXPECT_GT(found, 0);
}

}  // namespace flow_effects_test
