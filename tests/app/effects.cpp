// `pendular effects` and what the other commands make of a study's list of effects.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "data/effect_parameter.h"
#include "sim/catalogue/effect.h"
#include "tests/support/app_support.h"

namespace app_effects_test {

using pendular::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

const std::string start = pendular::grains_table + pendular::points_table;
const std::string cell = pendular::cell_table();
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

TEST(Effects, AreJson) {
    const Outcome all = run_pendular("effects --json -");
    ASSERT_EQ(all.code, 0) << all.errors;
    const auto list = nlohmann::json::parse(all.output).at("effects");
    const auto found = std::ranges::find_if(
        list, [](const auto& effect) { return effect.at("name") == "torque-offset"; });
    ASSERT_NE(found, list.end());
    auto one = nlohmann::json::parse(run_pendular("effects torque-offset --json -").output);
    EXPECT_EQ(one.at("format"), 2);
    one.erase("format");
    EXPECT_EQ(one, *found);
    EXPECT_EQ(one.at("acts_on"), "instrument");
    EXPECT_EQ(one.at("readings"), "all");
    EXPECT_EQ(one.at("written"), false);
    const auto& parameter = one.at("parameters").at(0);
    EXPECT_EQ(parameter.at("name"), "torque");
    EXPECT_EQ(parameter.at("unit"), "N m");
    EXPECT_EQ(parameter.at("upper"), 0.1);
    EXPECT_EQ(parameter.at("smallest_of_interest"), 1e-4);
    EXPECT_EQ(parameter.at("switch"), false);
    EXPECT_FALSE(one.contains("applies"));
}

TEST(Effects, PointToTheNearestName) {
    expect_refused(
        {"effects torque-ofset", "effects torque-offset other", "effects --study /nowhere/at/all"});
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
        std::vector<std::string> parts = {"# " + effect.name + "\n", effect.equation,
                                          "effects = [\"" + effect.name + "\"]"};
        for (const pendular::EffectParameter& p : effect.parameters) {
            const std::string unit = pendular::printed_unit(p).name;
            parts.push_back("| `" + p.name + "` | " + (p.is_switch() ? "switch" : unit) + " |");
            parts.push_back(p.meaning);
        }
        for (const std::string& reference : effect.references)
            parts.push_back("- " + reference + "\n");
        for (const std::string& part : parts)
            EXPECT_THAT(words, HasSubstr(part));
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
    expect_refused({"effects torque-offset --manual /tmp/nowhere"});
}

TEST_F(EffectsOfAStudy, AreShownWithThoseItWrites) {
    const std::string path = study(cell + drag + "[model]\neffects = [\"speed-drag\"]\n");
    const Outcome all = run_pendular("effects --study " + path);
    EXPECT_EQ(all.code, 0) << all.errors;
    expect_told({all.output});
    const Outcome one = run_pendular("effects speed-drag --study " + path);
    expect_told({one.output});
    expect_refused({"effects speed-drag"});
}

TEST_F(EffectsOfAStudy, AreShownWithWhatMeasuresThem) {
    const std::string method = "measured_by = \"the empty cell\"\nmeasured_to = \"0.5 mN m s\"\n";
    expect_told({run_pendular("effects speed-drag --study " + study(cell + drag + method)).output});
    // What was measured is a value of the study's own effect like any other.
    const std::string direct = study(cell + drag + method +
                                     "[[direct]]\neffect = \"speed-drag\"\nvalue = \"1 mN m s\"\n"
                                     "error = \"0.5 mN m s\"\n");
    EXPECT_EQ(run_pendular("effects --study " + direct).code, 0);
    expect_told({run_pendular("effects speed-drag --study " + study(cell + drag)).output});
}

TEST_F(EffectsOfAStudy, SayWhetherTheyApply) {
    const std::string path = study(drag);
    const Outcome all = run_pendular("effects --json - --study " + path);
    ASSERT_EQ(all.code, 0) << all.errors;
    const auto effects = nlohmann::json::parse(all.output).at("effects");
    for (const auto& effect : effects) {
        EXPECT_EQ(effect.at("listed"), false);
        if (effect.at("acts_on") == "instrument") {
            const std::string name = effect.at("name");
            const bool of_table =
                name != "speed-drag" && pendular::built_in_effect(name).of_table();
            EXPECT_EQ(effect.at("applies"), of_table) << name;
        }
    }
    expect_told({run_pendular("effects --study " + path).output});
    expect_told({run_pendular("effects --all --study " + path).output});
}

TEST_F(EffectsOfAStudy, AreCheckedByEveryCommandThatReadsOne) {
    std::string wrong = drag;
    wrong.replace(wrong.find("*angular"), 8, "*angulr");
    for (const std::string& text :
         {cell + "[model]\neffects = [\"torque-ofset\"]\n",
          std::string("[model]\neffects = [\"torque-offset\"]\n"), cell + wrong}) {
        const std::string path = study(text);
        expect_refused({"import " + path, "calibrate --quiet " + path, "compare " + path});
    }
}

}  // namespace app_effects_test
