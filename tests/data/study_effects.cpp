// Effects that a study lists and writes, as the study's reader takes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "data/study/study.h"
#include "tests/support/data_support.h"

namespace pendular::study_effects_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string start = R"([grains]
diameter = "500 um"
density = "1050 kg/m^3"
[[readings]]
file = "points.csv"
)";

const std::string drag = R"([[effect]]
name = "speed-drag"
parameter = "drag"
unit = "mN m s/rad"
lower = -50
upper = "0.05 N m s/rad"
torque = "torque + drag*angular_velocity"
)";

/// The [[effect]] above with one of its lines replaced, or taken out.
std::string drag_with(const std::string& key, const std::string& line) {
    std::string text = drag;
    const std::size_t begin = text.find("\n" + key + " =") + 1;
    return text.replace(begin, text.find('\n', begin) + 1 - begin, line.empty() ? "" : line + "\n");
}

class StudyEffects : public testing::Test {
  protected:
    Study read(const std::string& content) {
        folder_.write("points.csv", "a\n1\n");
        folder_.write("study.toml", start + content);
        return read_study(folder_.path());
    }
    std::string error(const std::string& content) {
        return input_error([&] { read(content); });
    }
    /// Beginning of an error at this place of the study.
    auto at(const std::string& position) const {
        return StartsWith((folder_.path() / "study.toml").string() + position);
    }

    TemporaryFolder folder_;
};

TEST_F(StudyEffects, AreListedWithTheirPlaces) {
    const auto effects = read("[model]\neffects = [\"b\",\n  'a', # why\n]\n").model.effects;
    ASSERT_EQ(effects.size(), 2u);
    EXPECT_EQ(effects[0].name, "b");
    EXPECT_EQ(effects[1].name, "a");
    EXPECT_THAT(to_string(effects[0].position), at(":7:12"));
    EXPECT_THAT(to_string(effects[1].position), at(":8:3"));
}

TEST_F(StudyEffects, AreListedOnce) {
    EXPECT_THAT(error("[model]\neffects = [\"a\", \"b\", \"a\"]\n"),
                at(":7:22: 'effects': \"a\" is listed twice"));
    EXPECT_THAT(error("[model]\neffects = [3]\n"), at(":7:12: must be a name"));
    EXPECT_THAT(error("[model]\neffects = \"a\"\n"), at(":7:11: 'effects': must be a list"));
}

TEST_F(StudyEffects, AreWrittenWithBoundsInSi) {
    const Study study = read(drag);
    ASSERT_EQ(study.written_effects.size(), 1u);
    const WrittenEffect& effect = study.written_effects[0];
    EXPECT_EQ(effect.name, "speed-drag");
    EXPECT_EQ(effect.parameter, "drag");
    EXPECT_DOUBLE_EQ(effect.lower, -0.05);
    EXPECT_DOUBLE_EQ(effect.upper, 0.05);
    EXPECT_EQ(effect.neutral, 0);
    EXPECT_DOUBLE_EQ(effect.smallest_of_interest, 0.01);  // a tenth of the range
    EXPECT_EQ(effect.summary, "");
    ASSERT_EQ(effect.formulas.size(), 1u);
    EXPECT_EQ(effect.formulas[0].target, "torque");
    EXPECT_EQ(effect.formulas[0].text, "torque + drag*angular_velocity");
    EXPECT_THAT(to_string(effect.formulas[0].position), at(":12:10"));
    EXPECT_THAT(to_string(effect.position), at(":6:1"));
    EXPECT_EQ(effect.kind(), WrittenEffect::Kind::instrument);
}

TEST_F(StudyEffects, TakeEveryKey) {
    const Study study = read(R"([[effect]]
name = "softening-2"
parameter = "x"
unit = "kPa"
lower = 0
upper = 2
neutral = "1000 Pa"
matters = 0.1
summary = "softer when pressed"
stress_ratio = "stress_ratio * x / 1000"
solid_fraction = "solid_fraction * x / 1000"
)");
    const WrittenEffect& effect = study.written_effects.at(0);
    EXPECT_EQ(effect.unit, "Pa");
    EXPECT_DOUBLE_EQ(effect.upper, 2000);
    EXPECT_DOUBLE_EQ(effect.neutral, 1000);
    EXPECT_DOUBLE_EQ(effect.smallest_of_interest, 100);
    EXPECT_EQ(effect.summary, "softer when pressed");
    EXPECT_EQ(effect.formulas.size(), 2u);
    EXPECT_EQ(effect.kind(), WrittenEffect::Kind::flow);
}

TEST_F(StudyEffects, MayBeSwitches) {
    const std::string start_of_switch = "[[effect]]\nname = \"a\"\nparameter = \"on\"\n";
    const std::string formula = "torque = \"torque*(1 + on)\"\n";
    const WrittenEffect effect = read(start_of_switch + formula).written_effects.at(0);
    EXPECT_EQ(effect.lower, 0);
    EXPECT_EQ(effect.upper, 1);
    EXPECT_EQ(effect.neutral, 0);
    EXPECT_NO_THROW(read(start_of_switch + "lower = 0\nupper = 1\n" + formula));
    EXPECT_THAT(error(start_of_switch + "upper = 2\n" + formula),
                at(":9:9: 'upper': of a switch is 1; leave it out"));
    EXPECT_THAT(error(start_of_switch + "unit = \"N\"\n" + formula), at(":9:8: 'unit': "));
    EXPECT_THAT(error(start_of_switch + "unit = \"wobbles\"\n" + formula), at(":9:8: 'unit': "));
}

TEST_F(StudyEffects, NeedTheirKeys) {
    for (const char* key : {"name", "parameter", "lower", "upper"})
        EXPECT_THAT(error(drag_with(key, "")),
                    AllOf(at(":6:1: "), HasSubstr("lacks '" + std::string(key) + "'")));
    EXPECT_THAT(error(drag_with("torque", "")),
                AllOf(at(":6:1: "), HasSubstr("'speed-drag' has no formula")));
}

TEST_F(StudyEffects, RefuseSummariesOfSeveralLines) {
    EXPECT_THAT(error(drag + "summary = \"one\\ntwo\"\n"),
                at(":13:11: 'summary': must be one line"));
}

TEST_F(StudyEffects, StateWhatMeasuresThem) {
    const WrittenEffect effect =
        read(drag + "measured_by = \"the empty cell\"\nmeasured_to = \"0.5 mN m s/rad\"\n")
            .written_effects.at(0);
    EXPECT_EQ(effect.measured_by, "the empty cell");
    EXPECT_DOUBLE_EQ(effect.measured_to, 5e-4);
    EXPECT_EQ(read(drag).written_effects.at(0).measured_by, "");
    EXPECT_THAT(error(drag + "measured_to = \"0.5 mN m s/rad\"\n"),
                at(":13:15: 'measured_to': is the standard error of a direct measurement; add "
                   "measured_by"));
    EXPECT_THAT(error(drag + "measured_by = \"a\"\nmeasured_to = \"1 N\"\n"), at(":14:15: "));
    EXPECT_THAT(error(drag + "measured_by = \"a\"\nmeasured_to = \"0 N m s/rad\"\n"),
                at(":14:15: 'measured_to': must be a standard error above 0"));
    EXPECT_THAT(error(drag + "measured_by = \"one\\ntwo\"\n"), HasSubstr("must be one line"));
    EXPECT_THAT(error("[[effect]]\nname = \"a\"\nparameter = \"on\"\nmeasured_by = \"a\"\n"
                      "torque = \"torque*(1 + on)\"\n"),
                HasSubstr("a switch has no size that could be measured"));
}

TEST_F(StudyEffects, RefuseUnknownKeys) {
    EXPECT_THAT(error(drag + "toruqe = \"1\"\n"),
                at(":13:1: unknown key 'toruqe' in [[effect]]; did you mean 'torque'?"));
    EXPECT_THAT(error("[effect]\nname = \"a\"\n"), HasSubstr("write [[effect]]"));
}

TEST_F(StudyEffects, RefuseNamesThatAreNone) {
    for (const char* name : {"", "Torque", "my effect", "my_effect", "-a", "a-", "a--b", "1a"})
        EXPECT_THAT(error(drag_with("name", "name = \"" + std::string(name) + "\"")),
                    AllOf(at(":7:8: 'name': "), HasSubstr("lower-case words")));
    for (const char* name : {"", "my drag", "1x", "a-b", "\u00b5"})
        EXPECT_THAT(error(drag_with("parameter", "parameter = \"" + std::string(name) + "\"")),
                    AllOf(at(":8:13: 'parameter': "), HasSubstr("one word")));
    EXPECT_THAT(error(drag + drag),
                at(":14:8: 'name': \"speed-drag\" is already defined in line 6"));
}

TEST_F(StudyEffects, RefuseImpossibleBounds) {
    EXPECT_THAT(error(drag_with("lower", "lower = nan")), at(":10:9: 'lower': must be finite"));
    EXPECT_THAT(error(drag_with("lower", "lower = 50.0")), at(":10:9: 'lower': must be less than"));
    EXPECT_THAT(error(drag_with("lower", "lower = 1")),
                AllOf(at(":6:1: 'neutral': "), HasSubstr("0 where 'neutral' is left out")));
    EXPECT_THAT(error(drag + "neutral = 60\n"), at(":13:11: 'neutral': "));
    EXPECT_THAT(error(drag + "matters = 0\n"), at(":13:11: 'matters': must be positive"));
    EXPECT_THAT(error(drag_with("upper", "upper = \"3 Pa\"")),
                AllOf(at(":11:9: 'upper': "), HasSubstr("measures")));
    EXPECT_THAT(error(drag_with("upper", "upper = []")), at(":11:9: 'upper': must be a quantity"));
    EXPECT_THAT(error(drag_with("unit", "unit = \"wobbles\"")), at(":9:8: 'unit': "));
    EXPECT_THAT(error(drag_with("unit", "unit = \"degC\"")), at(":9:8: 'unit': "));
}

TEST_F(StudyEffects, AreOfTheInstrumentOrOfTheBeads) {
    EXPECT_THAT(error(drag + "stress_ratio = \"stress_ratio + drag\"\n"),
                AllOf(at(":13:16: 'stress_ratio': "), HasSubstr("write two effects")));
    EXPECT_THAT(error(drag_with("torque", "torque = 3")), at(":12:10: 'torque': must be a string"));
}

}  // namespace pendular::study_effects_test
