// Effects that a study lists and writes, as the study's reader takes them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "data/study/study.h"
#include "tests/support/golden.h"

namespace pendular::study_effects_test {

const std::string start = grains_table + points_table;

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

    TemporaryFolder folder_;
};

TEST_F(StudyEffects, AreListedWithTheirPlaces) {
    const auto effects = read("[model]\neffects = [\"b\",\n  'a', # why\n]\n").model.effects;
    ASSERT_EQ(effects.size(), 2u);
    EXPECT_EQ(effects[0].name, "b");
    EXPECT_EQ(effects[1].name, "a");
    expect_told({to_string(effects[0].position), to_string(effects[1].position)});
}

TEST_F(StudyEffects, AreListedOnce) {
    expect_told({error("[model]\neffects = [\"a\", \"b\", \"a\"]\n"),
                 error("[model]\neffects = [3]\n"), error("[model]\neffects = \"a\"\n")});
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
    expect_told({to_string(effect.formulas[0].position), to_string(effect.position)});
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
    expect_told({error(start_of_switch + "upper = 2\n" + formula),
                 error(start_of_switch + "unit = \"N\"\n" + formula),
                 error(start_of_switch + "unit = \"wobbles\"\n" + formula)});
}

TEST_F(StudyEffects, NeedTheirKeys) {
    std::vector<std::string> told;
    for (const char* key : {"name", "parameter", "lower", "upper"})
        told.push_back(error(drag_with(key, "")));
    told.push_back(error(drag_with("torque", "")));
    expect_told(told);
}

TEST_F(StudyEffects, RefuseSummariesOfSeveralLines) {
    expect_told({error(drag + "summary = \"one\\ntwo\"\n")});
}

TEST_F(StudyEffects, StateWhatMeasuresThem) {
    const WrittenEffect effect =
        read(drag + "measured_by = \"the empty cell\"\nmeasured_to = \"0.5 mN m s/rad\"\n")
            .written_effects.at(0);
    EXPECT_EQ(effect.measured_by, "the empty cell");
    EXPECT_DOUBLE_EQ(effect.measured_to, 5e-4);
    EXPECT_EQ(read(drag).written_effects.at(0).measured_by, "");
    expect_told({error(drag + "measured_to = \"0.5 mN m s/rad\"\n"),
                 error(drag + "measured_by = \"a\"\nmeasured_to = \"1 N\"\n"),
                 error(drag + "measured_by = \"a\"\nmeasured_to = \"0 N m s/rad\"\n"),
                 error(drag + "measured_by = \"one\\ntwo\"\n"),
                 error("[[effect]]\nname = \"a\"\nparameter = \"on\"\nmeasured_by = \"a\"\n"
                       "torque = \"torque*(1 + on)\"\n")});
}

TEST_F(StudyEffects, RefuseUnknownKeys) {
    expect_told({error(drag + "toruqe = \"1\"\n"), error("[effect]\nname = \"a\"\n")});
}

TEST_F(StudyEffects, RefuseNamesThatAreNone) {
    std::vector<std::string> told;
    for (const char* name : {"", "Torque", "my effect", "my_effect", "-a", "a-", "a--b", "1a"})
        told.push_back(error(drag_with("name", "name = \"" + std::string(name) + "\"")));
    for (const char* name : {"", "my drag", "1x", "a-b", "\u00b5"})
        told.push_back(error(drag_with("parameter", "parameter = \"" + std::string(name) + "\"")));
    told.push_back(error(drag + drag));
    expect_told(told);
}

TEST_F(StudyEffects, RefuseImpossibleBounds) {
    expect_told(
        {error(drag_with("lower", "lower = nan")), error(drag_with("lower", "lower = 50.0")),
         error(drag_with("lower", "lower = 1")), error(drag + "neutral = 60\n"),
         error(drag + "matters = 0\n"), error(drag_with("upper", "upper = \"3 Pa\"")),
         error(drag_with("upper", "upper = []")), error(drag_with("unit", "unit = \"wobbles\"")),
         error(drag_with("unit", "unit = \"degC\""))});
}

TEST_F(StudyEffects, AreOfTheInstrumentOrOfTheBeads) {
    expect_told({error(drag + "stress_ratio = \"stress_ratio + drag\"\n"),
                 error(drag_with("torque", "torque = 3"))});
}

}  // namespace pendular::study_effects_test
