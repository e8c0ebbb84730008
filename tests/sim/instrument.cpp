// The instrument map and the conversions around it.
#include "sim/catalogue/instrument.h"

#include <cmath>
#include <numbers>

#include "sim/effects/wall_mobilisation.h"
#include "tests/support/golden.h"

namespace sim_instrument_test {

using namespace pendular;

const AnnularCell cell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 57e-6};
const GrainProperties grains{.diameter = 5e-4, .density = 1050};

/// An effect by name, its first parameter at a value.
ActiveEffect active(const std::string& name, double value) {
    const Effect& effect = built_in_effect(name);
    ActiveEffect result{&effect, effect.neutral()};
    result.values[0] = value;
    return result;
}

Condition some_condition() {
    return {.normal_stress = 700,
            .inertial_number = 0.013,
            .liquid_content = 0.02,
            .height = 0.0191,
            .bead_volume = 56e-6,
            .time = 5000};
}

CellState some_state() {
    return shown_state(some_condition(), 230, 0.59, cell, grains);
}

TEST(InstrumentMap, IsNothingWithoutEffects) {
    const InstrumentMap none, neutral({active("torque-gain", 1), active("wall-friction", 0),
                                       active("contact-angle", 0.1)});
    EXPECT_TRUE(none.empty());
    EXPECT_TRUE(neutral.empty());
    const CellState state = some_state();
    EXPECT_EQ(neutral.show(state).torque, state.torque);
    EXPECT_EQ(neutral.truth(state).angular_velocity, state.angular_velocity);
    const Condition shown = some_condition(), same = true_condition(shown, state, none);
    EXPECT_EQ(same.normal_stress, shown.normal_stress);
    EXPECT_EQ(same.inertial_number, shown.inertial_number);
    EXPECT_EQ(same.height, shown.height);
    const Eigen::Vector2d predicted(233.7, 0.5913);
    EXPECT_EQ(shown_reading(predicted, state, none, cell), predicted);
}

TEST(InstrumentMap, PutsBeadsBeforeTransducersAndNamesInOrder) {
    // The weight is that of the grains truly in the cell, the friction of the walls acts over the
    // true height and on the force less that weight, whatever scales show.
    const InstrumentMap map({active("wall-friction", 0.2), active("height-offset", 1e-3),
                             active("normal-force-offset", 0.5), active("grain-weight", 1),
                             active("bead-loss", 0.1)});
    const CellState truth = some_state(), shown = map.show(truth);
    const double lighter = truth.normal_force - truth.weight() / 2;
    const double k = 0.2 * 0.937 * truth.height / truth.width();
    EXPECT_DOUBLE_EQ(shown.normal_force, lighter * std::exp(carrying_share * k) + 0.5);
    EXPECT_DOUBLE_EQ(shown.bead_volume, truth.bead_volume / 0.9);
    EXPECT_DOUBLE_EQ(shown.height, truth.height + 1e-3);
}

TEST(InstrumentMap, NamesTheEffectsWhereNoStateIsShown) {
    const InstrumentMap map({active("normal-force-offset", 9)});
    try {
        map.truth(some_state());
        FAIL() << "no std::domain_error";
    } catch (const std::domain_error& error) {
        expect_told({error.what()});
    }
    EXPECT_THROW(InstrumentMap({active("height-offset", 2e-3)}).truth([] {
        CellState thin = some_state();
        thin.height = 1e-3;
        return thin;
    }()),
                 std::domain_error);
}

TEST(ShownState, UndoesTheImport) {
    for (const FormulaVariant form : {FormulaVariant::derived, FormulaVariant::as_printed}) {
        AnnularCell printed = cell;
        printed.torque_formula = form;
        const Condition condition = some_condition();
        const CellState state = shown_state(condition, 230, 0.59, printed, grains);
        printed.bead_volume = state.bead_volume;
        EXPECT_DOUBLE_EQ(shear_stress(state.torque, printed), 230);
        EXPECT_DOUBLE_EQ(normal_stress(state.normal_force, printed), 700);
        EXPECT_EQ(state.height, 0.0191);
        EXPECT_EQ(state.bead_volume, 56e-6);
        EXPECT_EQ(state.time, 5000);
        const double rate = shear_rate(state.angular_velocity, state.height, printed);
        EXPECT_DOUBLE_EQ(inertial_number(rate, 700, grains), 0.013);
    }
    // What is not recorded follows from the cell and the solid fraction.
    const CellState bare = shown_state({.normal_stress = 700}, 230, 0.59, cell, grains);
    EXPECT_EQ(bare.bead_volume, cell.bead_volume);
    EXPECT_DOUBLE_EQ(solid_fraction(bare.height, cell), 0.59);
    EXPECT_EQ(bare.angular_velocity, 0);
}

TEST(TrueCondition, FollowsFromTheTrueState) {
    const InstrumentMap map({active("normal-force-offset", 0.4), active("height-offset", 1e-3),
                             active("lid-slip", 0.2), active("bead-loss", 0.1),
                             active("liquid-loss", 1e-4)});
    const Condition shown = some_condition();
    const Condition truth = true_condition(shown, map.truth(some_state()), map);
    const double stress = 700 - 0.4 / cell.area(), height = 0.0191 - 1e-3;
    EXPECT_NEAR(truth.normal_stress, stress, 1e-9 * stress);
    // rate = omega (Ri + Re)/(2 H), I = rate sqrt(m/(a s22)).
    const double factor = 0.8 * (0.0191 / height) * std::sqrt(700 / stress);
    EXPECT_NEAR(truth.inertial_number, 0.013 * factor, 1e-10);
    EXPECT_NEAR(*truth.height, height, 1e-12);
    EXPECT_NEAR(*truth.bead_volume, 0.9 * 56e-6, 1e-15);
    EXPECT_NEAR(truth.liquid_content, 0.02 * std::exp(-0.5), 1e-12);
    EXPECT_EQ(truth.time, 5000);
}

TEST(TrueCondition, IsAsShownBitForBitWhereNoEffectActsOnIt) {
    const InstrumentMap map({active("torque-offset", 1e-3), active("torque-gain", 1.1)});
    const Condition shown = some_condition();
    const Condition truth = true_condition(shown, map.truth(some_state()), map);
    EXPECT_EQ(truth.normal_stress, shown.normal_stress);
    EXPECT_EQ(truth.inertial_number, shown.inertial_number);
    EXPECT_EQ(truth.liquid_content, shown.liquid_content);
    EXPECT_EQ(truth.height, shown.height);
    EXPECT_EQ(truth.bead_volume, shown.bead_volume);
}

TEST(TrueCondition, StaysQuasiStatic) {
    const InstrumentMap map({active("lid-slip", 0.2), active("wall-friction", 0.1)});
    Condition shown = some_condition();
    shown.inertial_number = 0;
    const CellState state = shown_state(shown, 230, 0.59, cell, grains);
    EXPECT_EQ(true_condition(shown, map.truth(state), map).inertial_number, 0);
}

TEST(ShownReading, AddsWhatTheInstrumentAdds) {
    const Eigen::Vector2d predicted(210, 0.6);
    const auto seen = [&](const ActiveEffect& effect) {
        const InstrumentMap map({effect});
        return shown_reading(predicted, map.truth(some_state()), map, cell);
    };
    const double radii = std::pow(0.045, 3) - std::pow(0.021, 3);
    const Eigen::Vector2d dragged = seen(active("torque-offset", 1e-3));
    EXPECT_NEAR(dragged(0), 210 + 3 * 1e-3 / (2 * std::numbers::pi * radii), 1e-9);
    EXPECT_NEAR(dragged(1), 0.6, 1e-12);
    EXPECT_NEAR(seen(active("torque-gain", 1.1))(0), 231, 1e-9);
    EXPECT_NEAR(seen(active("bead-loss", 0.04))(1), 0.6 / 0.96, 1e-12);
    // The gap that the predicted solid fraction makes, with the recorded grains.
    const double gap = 56e-6 / (0.6 * cell.area());
    EXPECT_NEAR(seen(active("height-offset", 1e-3))(1), 0.6 * gap / (gap + 1e-3), 1e-12);
    EXPECT_NEAR((seen(active("lid-slip", 0.3)) - predicted).norm(), 0, 1e-9);
}

TEST(TruthAtSetPoints, ShowsWhatWasAskedOfTheBeadsThereAre) {
    const InstrumentMap map({active("wall-friction", 0.3), active("grain-weight", 1),
                             active("height-offset", -1e-3), active("bead-loss", 0.1),
                             active("lid-slip", 0.2), active("torque-offset", 1e-3)});
    Condition asked = some_condition();
    asked.height = asked.bead_volume = std::nullopt;
    const FlowPoint flow{.stress_ratio = 0.31, .solid_fraction = 0.57};
    const CellState truth = truth_at_set_points(asked, flow, map, cell, grains);
    const CellState shown = map.show(truth);
    EXPECT_NEAR(normal_stress(shown.normal_force, cell), 700, 1e-8);
    const double rate = shear_rate(shown.angular_velocity, shown.height, cell);
    EXPECT_NEAR(inertial_number(rate, 700, grains), 0.013, 1e-12);
    EXPECT_NEAR(shown.bead_volume, cell.bead_volume, 1e-15);
    EXPECT_NEAR(truth.bead_volume / (truth.height * truth.area()), 0.57, 1e-12);
    const double stress = normal_stress(truth.normal_force, cell);
    EXPECT_NEAR(shear_stress(truth.torque, cell) / stress, 0.31, 1e-12);
    // The lid feels the force of mid-height less half the weight, raised by the walls.
    const double k = 0.3 * 0.937 * truth.height / truth.width();
    EXPECT_NEAR(stress, 700 / std::exp(carrying_share * k) + truth.weight() / 2 / truth.area(),
                1e-8);
}

}  // namespace sim_instrument_test
