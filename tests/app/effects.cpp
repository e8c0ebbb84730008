// `pendular effects` and what the other commands make of a study's list of effects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "data/printed_unit.h"
#include "sim/catalogue/effect.h"
#include "tests/support/app_support.h"

namespace app_effects_test {

using pendular::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string start = R"([grains]
diameter = "500 um"
density = "1050 kg/m^3"
[[readings]]
file = "points.csv"
)";
const std::string cell = R"([cell]
inner_radius = "21 mm"
outer_radius = "45 mm"
bead_mass = "60 g"
)";
const std::string drag = R"([[effect]]
name = "speed-drag"
parameter = "drag"
unit = "mN m s"
lower = -5
upper = 5
summary = "drag that grows with speed"
torque = "torque + drag*angular_velocity"
)";

/// A study of ready-made readings.
class EffectsOfAStudy : public testing::Test {
  protected:
    std::string study(const std::string& more) {
        folder_.write("points.csv",
                      "normal_stress [Pa],stress_ratio,solid_fraction,inertial_number\n"
                      "1000,0.3,0.6,0.01\n2000,0.3,0.6,0.01\n");
        folder_.write("study.toml", start + more);
        return folder_.path().string();
    }

    TemporaryFolder folder_;
};

TEST(Effects, ListsTheCatalogue) {
    const Outcome run = run_pendular("effects");
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.output,
                AllOf(HasSubstr("the instrument\n"), HasSubstr("torque-offset"), HasSubstr("mN m"),
                      HasSubstr("drag of bearings and seals"), Not(HasSubstr("applies"))));
    EXPECT_THAT(run_pendular("--help").output, HasSubstr("effects"));
    EXPECT_THAT(run_pendular("effects --help").output,
                AllOf(HasSubstr("Usage: pendular effects"), HasSubstr("Examples:")));
}

TEST(Effects, ShowsOneEntryWhole) {
    const Outcome run = run_pendular("effects torque-offset");
    EXPECT_EQ(run.code, 0) << run.errors;
    for (const char* part :
         {"T_shown = T + torque",
          "-100 to 100 mN m, no effect at 0 mN m, smallest size of interest 0.1 mN m",
          "normal stress (largest at small values)", "Schulze", "effects = [\"torque-offset\"]",
          "pendular virtual-lab OUT --torque-offset.torque \"0.1 mN m\"", "all readings"})
        EXPECT_THAT(run.output, HasSubstr(part));
}

// An effect that is on in every study with a liquid vanishes at the value in study.toml, not at 0.
TEST(Effects, AreShownFromTheValueOfTheLiquid) {
    EXPECT_THAT(
        run_pendular("effects capillary-bridges").output,
        AllOf(HasSubstr("no effect at the value in study.toml"),
              HasSubstr("virtual-lab OUT --capillary-bridges.surface_tension \"21.6 mN/m\"")));
}

TEST(Effects, AreJson) {
    const Outcome all = run_pendular("effects --json -");
    ASSERT_EQ(all.code, 0) << all.errors;
    const auto list = nlohmann::json::parse(all.output).at("effects");
    const auto found = std::ranges::find_if(
        list, [](const auto& effect) { return effect.at("name") == "torque-offset"; });
    ASSERT_NE(found, list.end());
    auto one = nlohmann::json::parse(run_pendular("effects torque-offset --json -").output);
    EXPECT_EQ(one.at("format"), 1);
    one.erase("format");
    EXPECT_EQ(one, *found);
    EXPECT_EQ(one.at("changes"), "instrument");
    EXPECT_EQ(one.at("touches"), "all");
    EXPECT_EQ(one.at("written"), false);
    const auto& parameter = one.at("parameters").at(0);
    EXPECT_EQ(parameter.at("name"), "torque");
    EXPECT_EQ(parameter.at("unit"), "N m");
    EXPECT_EQ(parameter.at("upper"), 0.1);
    EXPECT_EQ(parameter.at("matters"), 1e-4);
    EXPECT_EQ(parameter.at("switch"), false);
    EXPECT_FALSE(one.contains("applies"));
}

TEST(Effects, PointToTheNearestName) {
    expect_refused("effects torque-ofset", "did you mean 'torque-offset'?");
    expect_refused("effects torque-offset other", "too many arguments");
    expect_refused("effects --study /nowhere/at/all", "does not exist");
}

/// Text of a page without the signs that keep words from being Markdown.
std::string words_of(const std::filesystem::path& page) {
    std::string text = content_of(page);
    std::erase(text, '\\');
    return text;
}

/// Largest change of shear stress [%] or of 1000 times the solid fraction in the figure of an
/// effect.
double largest_change(const std::filesystem::path& numbers) {
    std::istringstream lines(content_of(numbers));
    double largest = 0;
    std::string line;
    std::getline(lines, line);  // the header: panel, curve, x, y, ...
    while (std::getline(lines, line)) {
        std::istringstream cells(line);
        std::string value;
        for (int k = 0; k < 4; ++k) {
            std::getline(cells, value, ',');
        }
        if (!value.empty()) largest = std::max(largest, std::abs(std::stod(value)));
    }
    return largest;
}

/// Expects that every link of a page leads to a file that is not empty.
void expect_links_resolve(const std::filesystem::path& page) {
    const std::string text = content_of(page);
    const std::regex link(R"(\]\(([^)]+)\))");
    for (std::sregex_iterator found(text.begin(), text.end(), link), end; found != end; ++found) {
        const auto target = page.parent_path() / (*found)[1].str();
        EXPECT_TRUE(std::filesystem::exists(target) && !std::filesystem::is_empty(target))
            << page << " links to " << target;
    }
}

TEST(EffectsManual, TellsAllThatIsKnownOfEveryEffect) {
    const TemporaryFolder folder;
    const auto manual = folder.path() / "manual";
    const Outcome run = run_pendular("effects --json - --manual " + manual.string());
    ASSERT_EQ(run.code, 0) << run.errors;
    expect_links_resolve(manual / "index.md");
    const std::string index = content_of(manual / "index.md");
    for (const pendular::Effect& effect : pendular::built_in_effects()) {
        EXPECT_THAT(index, HasSubstr("[" + effect.name + "](" + effect.name + ".md)"));
        const auto page = manual / (effect.name + ".md");
        const std::string words = words_of(page);
        EXPECT_THAT(words, AllOf(HasSubstr("# " + effect.name + "\n"), HasSubstr(effect.equation),
                                 HasSubstr("effects = [\"" + effect.name + "\"]")));
        for (const pendular::EffectParameter& p : effect.parameters) {
            const std::string unit = pendular::printed_unit(p).name;
            EXPECT_THAT(words, HasSubstr("| `" + p.name + "` | " +
                                         (p.is_switch() ? "switch" : unit) + " |"));
            EXPECT_THAT(words, HasSubstr(p.meaning));
        }
        for (const std::string& reference : effect.references) {
            EXPECT_THAT(words, HasSubstr("- " + reference + "\n"));
        }
        expect_links_resolve(page);
    }
    // Effects on grains have a figure where the atlas has runs with them, all others always.
    const auto pages = nlohmann::json::parse(run.output).at("pages");
    for (const auto& page : pages) {
        const std::string name = page.at("effect");
        const bool figure = page.at("figure");
        EXPECT_TRUE(figure || pendular::built_in_effect(name).of_grains()) << name;
        EXPECT_EQ(figure, std::filesystem::exists(manual / "figures" / (name + ".svg"))) << name;
        if (figure) {
            EXPECT_GT(largest_change(manual / "figures" / (name + ".csv")), 0.05) << name;
        }
    }
}

TEST(EffectsManual, IsOfAllEffects) {
    expect_refused("effects torque-offset --manual /tmp/nowhere", "leave out the name");
}

TEST_F(EffectsOfAStudy, AreShownWithThoseItWrites) {
    const std::string path = study(cell + drag + "[model]\neffects = [\"speed-drag\"]\n");
    const Outcome all = run_pendular("effects --study " + path);
    EXPECT_EQ(all.code, 0) << all.errors;
    EXPECT_THAT(all.output, AllOf(HasSubstr("speed-drag"), HasSubstr("drag that grows with speed"),
                                  testing::ContainsRegex("in the model +drag that grows")));
    const Outcome one = run_pendular("effects speed-drag --study " + path);
    EXPECT_THAT(one.output,
                AllOf(HasSubstr("torque_shown = torque + drag*angular_velocity"),
                      HasSubstr("study.toml:10"), HasSubstr("the model has the effect")));
    expect_refused("effects speed-drag", "unknown effect 'speed-drag'");
}

TEST_F(EffectsOfAStudy, AreShownWithWhatMeasuresThem) {
    const std::string method = "measured_by = \"the empty cell\"\nmeasured_to = \"0.5 mN m s\"\n";
    EXPECT_THAT(run_pendular("effects speed-drag --study " + study(cell + drag + method)).output,
                HasSubstr("the empty cell, to a standard error of 500 uN m s"));
    // What was measured is a value of the study's own effect like any other.
    const std::string direct = study(cell + drag + method +
                                     "[[direct]]\neffect = \"speed-drag\"\nvalue = \"1 mN m s\"\n"
                                     "error = \"0.5 mN m s\"\n");
    EXPECT_EQ(run_pendular("effects --study " + direct).code, 0);
    EXPECT_THAT(run_pendular("effects speed-drag --study " + study(cell + drag)).output,
                Not(HasSubstr("measured by")));
}

TEST_F(EffectsOfAStudy, SayWhetherTheyApply) {
    const std::string path = study(drag);
    const Outcome all = run_pendular("effects --json - --study " + path);
    ASSERT_EQ(all.code, 0) << all.errors;
    const auto effects = nlohmann::json::parse(all.output).at("effects");
    for (const auto& effect : effects) {
        EXPECT_EQ(effect.at("listed"), false);
        if (effect.at("changes") == "instrument") {
            EXPECT_EQ(effect.at("applies"), false);
            EXPECT_THAT(effect.at("why_not").get<std::string>(),
                        HasSubstr(effect.at("touches") == "wet" ? "no [liquid]" : "no [cell]"));
        }
    }
    const std::string table = run_pendular("effects --study " + path).output;
    const auto in_table = [&](const char* row) {
        return std::regex_search(table, std::regex(row));
    };
    EXPECT_TRUE(in_table("torque-offset +torque +mN m +all +needs \\[cell\\] +drag")) << table;
    EXPECT_TRUE(in_table("contact-angle +angle +deg +wet +needs \\[liquid\\] +the")) << table;
    EXPECT_TRUE(in_table("contact-stress +on +switch +wet +needs \\[liquid\\] +the")) << table;
    EXPECT_TRUE(in_table("polydispersity +deviation +1 +all +yes +the")) << table;
    EXPECT_THAT(table, Not(HasSubstr("Note:")));
    EXPECT_THAT(run_pendular("effects --all --study " + path).output,
                HasSubstr("Note: torque-offset"));
}

TEST_F(EffectsOfAStudy, AreCheckedByEveryCommandThatReadsOne) {
    const std::string unknown = study(cell + "[model]\neffects = [\"torque-ofset\"]\n");
    for (const std::string command : {"import ", "calibrate --quiet ", "compare "})
        expect_refused(command + unknown,
                       "study.toml:11:12: 'effects': unknown effect 'torque-ofset'; did you mean "
                       "'torque-offset'?");
    const std::string useless = study("[model]\neffects = [\"torque-offset\"]\n");
    for (const std::string command : {"import ", "calibrate --quiet ", "compare "})
        expect_refused(command + useless, "study.toml:7:12: 'effects': torque-offset acts on");
    std::string wrong = drag;
    wrong.replace(wrong.find("*angular"), 8, "*angulr");
    for (const std::string command : {"import ", "calibrate --quiet ", "compare "})
        expect_refused(command + study(cell + wrong), "study.toml:17:10: ");
}

}  // namespace app_effects_test
