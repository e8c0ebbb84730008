// Laws of the effects that are maps: of the instrument, and of grains and liquid.
#include <cmath>
#include <random>

#include "registered_effects.h"
#include "sim/catalogue/instrument.h"

namespace instrument_effects_test {

using namespace pendular;

constexpr std::array fields = {&CellState::torque,         &CellState::normal_force,
                               &CellState::height,         &CellState::angular_velocity,
                               &CellState::liquid_content, &CellState::bead_volume,
                               &CellState::time,           &CellState::inner_radius,
                               &CellState::outer_radius,   &CellState::density,
                               &CellState::diameter};

bool same_bits(const CellState& a, const CellState& b) {
    return std::ranges::all_of(fields, [&](auto field) { return a.*field == b.*field; });
}

bool finite(const CellState& state) {
    return std::ranges::all_of(fields, [&](auto field) { return std::isfinite(state.*field); });
}

/// Largest difference of two states relative to the values of the first, the torque to that of a
/// stress ratio of 0.1 at least, as the map has it.
double difference(const CellState& a, const CellState& b) {
    double largest = 0;
    for (const auto field : fields) {
        const double least =
            field == &CellState::torque ? 0.1 * a.normal_force * a.outer_radius : 0;
        const double size = std::max(std::abs(a.*field), least);
        if (size > 0) largest = std::max(largest, std::abs(a.*field - b.*field) / size);
    }
    return largest;
}

/// States of a small and a large cell: 0.2 to 5 kPa, shear rates of 0.01 to 100 per second, samples
/// of 8 to 40 diameters, up to three hours after the beginning.
std::vector<CellState> states() {
    std::mt19937_64 random(7);
    const auto between = [&](double low, double high) {
        return low * std::pow(high / low, std::uniform_real_distribution<double>()(random));
    };
    std::vector<CellState> all;
    for (int k = 0; k < 200; ++k) {
        CellState s{.inner_radius = between(0.005, 0.03), .density = 1050, .diameter = 5e-4};
        s.outer_radius = s.inner_radius * between(1.3, 4);
        s.normal_force = between(200, 5000) * s.area();
        s.height = s.diameter * between(8, 40);
        s.torque = between(0.1, 1) * s.normal_force * (s.inner_radius + s.outer_radius) / 2;
        s.angular_velocity = between(0.01, 100) * 2 * s.height / (s.inner_radius + s.outer_radius);
        s.liquid_content = k % 3 == 0 ? 0 : between(0.002, 0.06);
        s.bead_volume = between(0.55, 0.65) * s.area() * s.height;
        s.time = k % 5 == 0 ? 0 : between(1, 1e4);
        all.push_back(s);
    }
    return all;
}

class InstrumentEffects : public EveryEffect {
  protected:
    CellState shown(const CellState& truth, const std::vector<double>& values) const {
        return std::get<ChangeInstrument>(effect().change)
            .show(truth, Values(effect().parameters, values));
    }
};

/// A wet and a dry condition, with the liquid filled in where it is wet.
std::vector<EffectiveCondition> conditions() {
    EffectiveCondition wet =
        Condition{.normal_stress = 600, .inertial_number = 0.01, .liquid_content = 0.02};
    wet.liquid = Liquid{.surface_tension = 20.6e-3, .contact_angle = 0.3, .viscosity = 0.05};
    wet.friction_difference = 0.01;
    return {wet, Condition{.normal_stress = 600, .inertial_number = 0.01}};
}

bool same(const EffectiveCondition& a, const EffectiveCondition& b) {
    return a.normal_stress == b.normal_stress && a.inertial_number == b.inertial_number &&
           a.liquid_content == b.liquid_content && a.height == b.height &&
           a.bead_volume == b.bead_volume && a.time == b.time &&
           a.friction_difference == b.friction_difference && a.grain_effects == b.grain_effects &&
           a.liquid.has_value() == b.liquid.has_value() &&
           (!a.liquid || (a.liquid->surface_tension == b.liquid->surface_tension &&
                          a.liquid->contact_angle == b.liquid->contact_angle &&
                          a.liquid->viscosity == b.liquid->viscosity));
}

class ConditionEffects : public EveryEffect {
  protected:
    EffectiveCondition changed(const EffectiveCondition& condition,
                               const std::vector<double>& values) const {
        return changed_condition(condition, {{&effect(), values}}, std::nullopt);
    }
    bool touches(const EffectiveCondition& condition) const {
        return !touching({{&effect(), effect().neutral()}}, condition).empty();
    }
};

TEST_P(InstrumentEffects, VanishesAtItsNeutralValue) {
    for (const CellState& truth : states()) {
        EXPECT_TRUE(same_bits(shown(truth, effect().neutral()), truth));
    }
}

TEST_P(InstrumentEffects, ChangesSomethingAtTheSizeThatMatters) {
    // Less than a part in a million of every value would be below what a rheometer shows.
    for (const auto& values : values_that_matter(effect())) {
        double largest = 0;
        for (const CellState& truth : states()) {
            largest = std::max(largest, difference(truth, shown(truth, values)));
        }
        EXPECT_GT(largest, 1e-6);
    }
}

TEST_P(InstrumentEffects, TheMapInverts) {
    auto all = corners(effect());
    for (const auto& values : values_that_matter(effect())) {
        all.push_back(values);
    }
    for (const auto& values : all) {
        const InstrumentMap map({{&effect(), values}});
        for (const CellState& truth : states()) {
            EXPECT_LT(difference(truth, map.truth(map.show(truth))), 1e-10) << values[0];
        }
    }
}

TEST_P(InstrumentEffects, IsFiniteAtTheCornersOfItsBounds) {
    for (const auto& corner : corners(effect())) {
        for (const CellState& truth : states()) {
            EXPECT_TRUE(finite(shown(truth, corner)));
        }
    }
}

TEST_P(InstrumentEffects, LeavesTimeAndGeometryAlone) {
    for (const auto& corner : corners(effect())) {
        for (const CellState& truth : states()) {
            const CellState seen = shown(truth, corner);
            for (const auto field :
                 {&CellState::time, &CellState::inner_radius, &CellState::outer_radius,
                  &CellState::density, &CellState::diameter}) {
                EXPECT_EQ(seen.*field, truth.*field);
            }
        }
    }
}

TEST_P(InstrumentEffects, LeavesBeadsAloneThatItDoesNotTouch) {
    if (effect().touches != Touches::wet) return;
    for (CellState truth : states()) {
        truth.liquid_content = 0;
        for (const auto& corner : corners(effect())) {
            EXPECT_TRUE(same_bits(shown(truth, corner), truth));
        }
    }
}

TEST(Instrument, AllItsEffectsTogetherInvert) {
    std::vector<ActiveEffect> effects;
    for (const std::string& name :
         names_of_effects([](const Effect& e) { return e.of_instrument(); })) {
        const Effect& effect = built_in_effect(name);
        effects.push_back({&effect, values_that_matter(effect).back()});
    }
    const InstrumentMap map(effects);
    for (const CellState& truth : states()) {
        EXPECT_LT(difference(truth, map.truth(map.show(truth))), 1e-10);
    }
}

TEST_P(ConditionEffects, VanishesAtItsNeutralValue) {
    for (const EffectiveCondition& condition : conditions()) {
        EffectiveCondition without = condition;
        // Where an effect is on without being listed, gone means gone with the forces of the
        // liquid.
        if (effect().given_by_liquid) {
            without.liquid_content = 0;
            if (without.liquid) without.liquid->surface_tension = 0;
        }
        EXPECT_TRUE(same(changed(condition, effect().neutral()), without));
    }
}

TEST_P(ConditionEffects, ChangesSomethingAtTheSizeThatMatters) {
    for (const EffectiveCondition& condition : conditions()) {
        if (!touches(condition)) continue;
        for (const auto& values : values_that_matter(effect())) {
            EXPECT_FALSE(same(changed(condition, values), condition));
        }
    }
}

TEST_P(ConditionEffects, LeavesBeadsAloneThatItDoesNotTouch) {
    for (const EffectiveCondition& condition : conditions()) {
        if (touches(condition)) continue;
        for (const auto& corner : corners(effect())) {
            EXPECT_TRUE(same(changed(condition, corner), condition));
        }
    }
}

TEST_P(ConditionEffects, IsFiniteAtTheCornersOfItsBounds) {
    const GrainProperties grains{.diameter = 5e-4, .density = 1050};
    for (const EffectiveCondition& condition : conditions()) {
        for (const auto& corner : corners(effect())) {
            const EffectiveCondition c = changed(condition, corner);
            EXPECT_TRUE(std::isfinite(c.friction_difference));
            EXPECT_GE(c.liquid_content, 0);
            if (c.dry()) continue;
            // Bridges attract.
            EXPECT_GT(pull_off_force(grains, *c.liquid), 0);
            EXPECT_TRUE(std::isfinite(reduced_pressure(c.normal_stress, grains, *c.liquid)));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Effects, InstrumentEffects,
                         testing::ValuesIn(names_of_effects([](const Effect& effect) {
                             return effect.of_instrument();
                         })),
                         test_name);
INSTANTIATE_TEST_SUITE_P(Effects, ConditionEffects,
                         testing::ValuesIn(names_of_effects([](const Effect& effect) {
                             return effect.of_condition();
                         })),
                         test_name);

}  // namespace instrument_effects_test
