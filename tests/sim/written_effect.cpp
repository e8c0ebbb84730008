// Effects that users write as formulas.
#include "sim/catalogue/written_effect.h"

#include <fmt/format.h>

#include <cmath>
#include <thread>

#include "data/study/study_table.h"
#include "sim/catalogue/formula.h"
#include "tests/support/golden.h"

namespace pendular::written_effect_test {

using testing::ElementsAre;

/// Effect that the study's reader makes from an [[effect]] with parameter `x` from -2 to 2; its
/// formula is in line 6, column 10 on.
WrittenEffect written(const std::string& formulas, const std::string& parameter = "x") {
    const std::string text =
        fmt::format("[[effect]]\nname = \"mine\"\nparameter = \"{}\"\nlower = -2\nupper = 2\n{}\n",
                    parameter, formulas);
    return read_written_effects(StudyTable::parse("study.toml", text, {"effect"})).at(0);
}

Effect effect(const std::string& formulas) {
    return effect_from(written(formulas));
}

std::string error(const std::string& formulas, const std::string& parameter = "x") {
    return input_error([&] { effect_from(written(formulas, parameter)); });
}

CellState cell_state() {
    return {.torque = 0.1,
            .normal_force = 10,
            .height = 0.02,
            .angular_velocity = 0.5,
            .liquid_content = 0.03,
            .bead_volume = 5e-5,
            .time = 100,
            .inner_radius = 0.02,
            .outer_radius = 0.04,
            .density = 1000,
            .diameter = 1e-3};
}

CellState shown(const Effect& effect, double value, const CellState& state = cell_state()) {
    const std::vector<double> values = {value};
    return std::get<ChangeInstrument>(effect.change).show(state, {effect.parameters, values});
}

FlowPoint shown(const Effect& effect, double value, const Condition& condition) {
    const std::vector<double> values = {value};
    return std::get<ChangeFlow>(effect.change)
        .change({0.3, 0.6}, condition, {effect.parameters, values});
}

TEST(WrittenEffect, ShowsWhatItsFormulaGives) {
    const Effect drag = effect("torque = \"torque + x*angular_velocity\"");
    EXPECT_DOUBLE_EQ(shown(drag, 0.2).torque, 0.1 + 0.2 * 0.5);
    EXPECT_EQ(shown(drag, 0.2).normal_force, 10);
    EXPECT_EQ(shown(drag, 0).torque, 0.1);
    EXPECT_TRUE(drag.of_instrument());
}

TEST(WrittenEffect, KnowsTheWholeState) {
    const auto at_one = [](const std::string& term) {
        return shown(effect("torque = \"torque + x*" + term + "\""), 1).torque - 0.1;
    };
    const double rounding = 1e-12;
    EXPECT_NEAR(at_one("torque"), 0.1, rounding);
    EXPECT_NEAR(at_one("normal_force"), 10, rounding);
    EXPECT_NEAR(at_one("height"), 0.02, rounding);
    EXPECT_NEAR(at_one("angular_velocity"), 0.5, rounding);
    EXPECT_NEAR(at_one("liquid_content"), 0.03, rounding);
    EXPECT_NEAR(at_one("bead_volume*1e6"), 50, rounding);
    EXPECT_NEAR(at_one("time"), 100, rounding);
    EXPECT_NEAR(at_one("inner_radius"), 0.02, rounding);
    EXPECT_NEAR(at_one("outer_radius"), 0.04, rounding);
    EXPECT_NEAR(at_one("density"), 1000, 1e-9);
    EXPECT_NEAR(at_one("diameter*1e3"), 1, rounding);
    EXPECT_NEAR(at_one("normal_stress"), 10 / (M_PI * (0.04 * 0.04 - 0.02 * 0.02)), 1e-9);
    EXPECT_NEAR(at_one("pi"), M_PI, rounding);
}

TEST(WrittenEffect, ReadsTheTrueStateInAllFormulas) {
    const Effect both =
        effect("torque = \"torque + x*normal_force\"\nnormal_force = \"normal_force + x*torque\"");
    EXPECT_DOUBLE_EQ(shown(both, 1).torque, 10.1);
    EXPECT_DOUBLE_EQ(shown(both, 1).normal_force, 10.1);
    EXPECT_EQ(both.equation,
              "torque_shown = torque + x*normal_force\n"
              "normal_force_shown = normal_force + x*torque");
}

TEST(WrittenEffect, OfTheInstrumentChangesEachOfItsTargets) {
    EXPECT_DOUBLE_EQ(shown(effect("height = \"height*(1 + x)\""), 1).height, 0.04);
    EXPECT_DOUBLE_EQ(
        shown(effect("angular_velocity = \"angular_velocity*(1 - x/4)\""), 1).angular_velocity,
        0.375);
}

TEST(WrittenEffect, OfTheBeadsKnowsTheCondition) {
    Condition condition{.normal_stress = 1000, .inertial_number = 0.01, .liquid_content = 0.03};
    condition.height = 0.02;
    condition.time = 60;
    const Effect mine = effect(
        "stress_ratio = \"stress_ratio + x*(normal_stress + inertial_number + liquid_content + "
        "height + time + solid_fraction)\"\nsolid_fraction = \"solid_fraction - x*stress_ratio\"");
    EXPECT_DOUBLE_EQ(shown(mine, 1, condition).stress_ratio,
                     0.3 + 1000 + 0.01 + 0.03 + 0.02 + 60 + 0.6);
    EXPECT_DOUBLE_EQ(shown(mine, 1, condition).solid_fraction, 0.3);
    EXPECT_EQ(shown(mine, 0, condition).stress_ratio, 0.3);
    EXPECT_FALSE(mine.of_instrument());
    condition.height.reset();
    expect_told({input_error([&] { shown(mine, 1, condition); })});
}

TEST(WrittenEffect, ChangesPropertiesOfGrainsAndLiquid) {
    const auto changed = [](const std::string& formulas, const EffectiveCondition& condition) {
        const Effect mine = effect(formulas);
        const std::vector<double> values = {1};
        return std::get<ChangeCondition>(mine.change).change(condition, {mine.parameters, values});
    };
    EffectiveCondition wet(
        Condition{.normal_stress = 1000, .inertial_number = 0.01, .liquid_content = 0.03});
    wet.liquid = Liquid{.surface_tension = 0.02};
    wet.friction_difference = 0.1;
    const EffectiveCondition after = changed(
        "friction_difference = \"friction_difference + x*inertial_number\"\n"
        "surface_tension = \"surface_tension*(1 + x*liquid_content)\"",
        wet);
    EXPECT_DOUBLE_EQ(after.friction_difference, 0.11);
    EXPECT_DOUBLE_EQ(after.liquid->surface_tension, 0.02 * 1.03);
    const EffectiveCondition dry(Condition{.normal_stress = 1000, .inertial_number = 0.01});
    EXPECT_DOUBLE_EQ(
        changed("friction_difference = \"friction_difference + x\"", dry).friction_difference, 1);
    EXPECT_EQ(effect("surface_tension = \"surface_tension*(1 + x)\"").touches, Touches::wet);
    EXPECT_EQ(effect("friction_difference = \"friction_difference + x\"").equation,
              "friction_difference becomes friction_difference + x");
}

TEST(WrittenEffect, IsDescribedLikeABuiltInOne) {
    const Effect mine = effect(
        "unit = \"mN m\"\nsummary = \"drag\"\nmatters = 0.5\n"
        "torque = \"torque + x*(1 + time/3600)*normal_force\"");
    EXPECT_EQ(mine.name, "mine");
    EXPECT_EQ(mine.summary, "drag");
    EXPECT_EQ(mine.parameters.at(0).name, "x");
    EXPECT_EQ(mine.parameters.at(0).unit, "N m");
    EXPECT_DOUBLE_EQ(mine.parameters.at(0).lower, -2e-3);
    EXPECT_DOUBLE_EQ(mine.parameters.at(0).upper, 2e-3);
    EXPECT_DOUBLE_EQ(mine.parameters.at(0).smallest_of_interest, 0.5e-3);
    EXPECT_THAT(mine.acts_through, testing::UnorderedElementsAre("normal_stress", "time"));
    EXPECT_THAT(mine.references, ElementsAre("study.toml:1"));
}

TEST(WrittenEffect, FindsOutWhichReadingsItTouches) {
    EXPECT_EQ(effect("torque = \"torque + x\"").touches, Touches::all);
    EXPECT_EQ(effect("torque = \"torque + x*liquid_content\"").touches, Touches::wet);
    EXPECT_EQ(effect("torque = \"liquid_content > 0 ? torque : torque + x\"").touches,
              Touches::dry);
    EXPECT_EQ(effect("stress_ratio = \"stress_ratio*(1 + x*liquid_content)\"").touches,
              Touches::wet);
}

TEST(WrittenEffect, MayBeASwitch) {
    const WrittenEffect text =
        read_written_effects(StudyTable::parse("study.toml",
                                               "[[effect]]\nname = \"mine\"\nparameter = \"on\"\n"
                                               "torque = \"torque*(1 + on/2)\"\n",
                                               {"effect"}))
            .at(0);
    const Effect mine = effect_from(text);
    EXPECT_TRUE(mine.is_switch());
    EXPECT_DOUBLE_EQ(shown(mine, 1).torque, 0.15);
}

TEST(WrittenEffect, RefusesWhatIsNoFormula) {
    std::vector<std::string> told;
    for (const std::string formula :
         {"torque + x*anguler_velocity", "torque + x*stress_ratio", "torque + (x", "torque + x)",
          "", "  ", "torque +", "torque x", "torque \u00d7 x", "torque = torque + x",
          "torque + x\\u0000*1e9", "torque + 1,5*x", "torque + sin()*x"})
        told.push_back(error("torque = \"" + formula + "\""));
    told.push_back(error("torque = \"" + std::string(6000, '(') + "\""));
    expect_told(told);
}

TEST(WrittenEffect, TakesComparisonsForWhatTheyAre) {
    EXPECT_EQ(shown(effect("torque = \"time >= 100 && x != 0 ? 2*torque : torque\""), 1).torque,
              0.2);
    EXPECT_EQ(shown(effect("torque = \"x == 0 ? torque : 3\""), 1).torque, 3);
}

TEST(WrittenEffect, RefusesAFormulaWithoutItsParameter) {
    expect_told({error("torque = \"1.02*torque\"")});
}

TEST(WrittenEffect, RefusesAUnitThatDoesNotFitItsFormula) {
    const auto with_unit = [](const std::string& unit, const std::string& formula) {
        return "unit = \"" + unit + "\"\n" + formula;
    };
    const std::string drag = "torque = \"torque + x*angular_velocity\"";
    EXPECT_NO_THROW(effect(with_unit("mN m s/rad", drag)));
    EXPECT_NO_THROW(effect(with_unit("N m s", drag)));  // angles count as numbers
    expect_told({error(with_unit("mN", drag)),
                 error(with_unit("N", "height = \"height*(1 + x^2*time)\"")),
                 error(with_unit("N", "torque = \"torque + x*angular_velocity*time\"")),
                 error(with_unit("s", "torque = \"torque + x*time + x*height\""))});
    EXPECT_NO_THROW(effect(drag));  // without a unit nothing is stated that could be wrong
    // A number may have a dimension.
    EXPECT_NO_THROW(effect(with_unit("N m", "torque = \"torque + x*angular_velocity/3\"")));
    EXPECT_NO_THROW(effect(with_unit("N m", "torque = \"torque + (time > 1 ? x : 0)\"")));
}

TEST(WrittenEffect, RefusesToChangeAnythingAtItsNeutralValue) {
    expect_told({error("torque = \"torque*x\""), error("torque = \"torque + x + 1e-9\""),
                 error("torque = \"torque/x\""),
                 error("torque = \"torque + x*0 + liquid_content\"")});
    // Processors give a nan this sign or that.
    EXPECT_THAT(error("torque = \"torque + x/x\""), testing::HasSubstr("must give back"));
    EXPECT_NO_THROW(effect("neutral = 1\ntorque = \"torque*x\""));
}

TEST(WrittenEffect, RefusesWhatIsNoNumberAtABound) {
    expect_told({error("torque = \"torque*exp(x*time)\"")});
    EXPECT_THAT(error("torque = \"torque*sqrt(1 + x)\""),
                testing::HasSubstr("nan at torque = 0.012, x = -2"));
}

TEST(WrittenEffect, IsNotBlamedForAStateThatDoesNotExist) {
    const Effect drift = effect("torque = \"torque + x*0.06*time\"");
    CellState nowhere = cell_state();
    nowhere.torque = NAN;
    EXPECT_THROW(shown(drift, 1, nowhere), std::domain_error);
    nowhere = cell_state();
    nowhere.height = NAN;  // which the formula does not read
    EXPECT_NO_THROW(shown(drift, 1, nowhere));
    const Effect wrong = effect("torque = \"torque + x/(height - 0.03)\"");
    CellState there = cell_state();
    there.height = 0.03;
    EXPECT_THROW(shown(wrong, 1, there), InputError);
}

TEST(WrittenEffect, RefusesAParameterThatHidesSomething) {
    std::vector<std::string> told;
    for (const char* name : {"torque", "stress_ratio", "time", "sin", "pi", "_e"})
        told.push_back(error("torque = \"torque + 1\"", name));
    expect_told(told);
}

// muParser's parsers are not thread-safe; without the lock this mixes the threads' variables.
TEST(WrittenEffect, CanBeUsedFromSeveralThreads) {
    const Effect mine = effect(
        "torque = \"torque + x*time + sin(normal_force) - "
        "sin(normal_force)*exp(0)\"");
    std::vector<std::thread> threads;
    std::vector<int> wrong(4);
    for (int t = 0; t < 4; ++t) {
        threads.emplace_back([&, t] {
            for (int k = 0; k < 20000; ++k) {
                CellState state = cell_state();
                state.time = t + k;
                wrong[static_cast<std::size_t>(t)] +=
                    std::abs(shown(mine, 1, state).torque - (0.1 + t + k)) > 1e-9 * (1 + t + k);
            }
        });
    }
    for (auto& thread : threads)
        thread.join();
    EXPECT_THAT(wrong, ElementsAre(0, 0, 0, 0));
}

TEST(CompiledFormula, SharesNothingBetweenFormulas) {
    const CompiledFormula sum("a + b", {"a", "b"}), product("a*b", {"a", "b"});
    const CompiledFormula copy = sum;
    EXPECT_EQ(sum(std::vector{2.0, 3.0}), 5);
    EXPECT_EQ(product(std::vector{2.0, 3.0}), 6);
    EXPECT_EQ(copy(std::vector{4.0, 3.0}), 7);
    EXPECT_THAT(product.used(), ElementsAre("a", "b"));
    EXPECT_FALSE(CompiledFormula("2*a", {"a", "b"}).uses("b"));
}

}  // namespace pendular::written_effect_test
