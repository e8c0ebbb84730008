// Changes that no known effect makes: the diagnosis names their shape.
#include "analysis/proposals/propose.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>

#include "analysis/proposals/scored_shapes.h"
#include "reports/proposal_report.h"
#include "tests/physics/planted_readings.h"
#include "tests/support/app_support.h"

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

/// Readings of the laboratory with a hidden effect and random errors.
std::vector<Reading> readings_hiding(const Effect& hidden, std::uint64_t seed) {
    const std::vector<Effect> more = {hidden};
    const StudyModelSpace with_hidden = models().offering(more);
    const std::shared_ptr<const Model> truth = with_hidden.with({models().candidates().size()});
    const Eigen::VectorXd parameters = Eigen::VectorXd::Constant(1, planted_friction);
    std::mt19937_64 random(seed);
    return scattered(conditions(), truth->predict(parameters, PredictionPart::values).value,
                     random);
}

/// Proposals for readings of the laboratory with a hidden effect and random errors.
std::vector<Proposal> proposals_for(const Effect& hidden, std::uint64_t seed) {
    const auto readings = readings_hiding(hidden, seed);
    const Evidence evidence = evidence_of(readings, {});
    const DiagnosisOptions options;
    const Diagnosis diagnosis = diagnose(models(), evidence, options);
    EXPECT_FALSE(diagnosis.complete);
    return propose(planted_study(), models(), evidence, readings, diagnosis, options);
}

/// Drag of a seal, which grows with the speed; `drag`: torque over angular velocity [N m s/rad].
Effect seal_drag(double drag) {
    return unknown_effect([drag](CellState s) {
        s.torque += drag * s.angular_velocity;
        return s;
    });
}

TEST(Proposals, NameADragThatGrowsWithSpeed) {
    const double drag = 4e-4;  // [N m s/rad]
    const auto proposals = proposals_for(seal_drag(drag), 11);
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

TEST(Proposals, ReplaceLeadingEffectsAndAreAddedByTheirNumber) {
    // At twice this drag no known effect comes close, and there are no leaders to replace.
    const auto readings = readings_hiding(seal_drag(2.5e-4), 15);
    const Diagnosis alone = diagnose(models(), evidence_of(readings, {}));
    ASSERT_TRUE(alone.leaders);  // known effects lead, without explaining all
    TemporaryFolder folder;
    std::string table =
        "normal_stress [Pa],shear_stress [Pa],solid_fraction,inertial_number,liquid_content,"
        "height [m],time [s]\n";
    for (const Reading& reading : readings) {
        const Condition& c = reading.condition;
        table += fmt::format("{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g},{:.8g}\n", c.normal_stress,
                             reading.value(0), reading.value(1), c.inertial_number,
                             c.liquid_content, *c.height, c.time);
    }
    folder.write("points.csv", table);
    const std::string study = folder
                                  .write("study.toml", R"([grains]
diameter = "500 um"
density = "1050 kg/m^3"
[liquid]
surface_tension = "20.6 mN/m"
contact_angle = "0 deg"
[cell]
inner_radius = "21 mm"
outer_radius = "45 mm"
bead_mass = "60 g"
[[readings]]
file = "points.csv"
[scatter]
shear_stress = 0.01
solid_fraction = 0.002
[model]
effects = []
)")
                                  .string();
    const auto run = [&](const std::string& words) {
        const Outcome outcome = run_pendular(words + " --fidelity quick --quiet --json -");
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return nlohmann::json::parse(outcome.output);
    };
    const std::string printed =
        run_pendular("diagnose " + study + " --fidelity quick --quiet").output;
    EXPECT_LE(std::ranges::count(printed, '\n'), 25) << printed;
    EXPECT_NE(printed.find("Check the torque transducer"), std::string::npos) << printed;
    const std::string planned = run_pendular("next " + study + " --fidelity quick --quiet").output;
    EXPECT_NE(planned.find("1. Check the torque transducer"), std::string::npos) << planned;
    EXPECT_LT(planned.find("torque transducer"), planned.find("--proposed 1")) << planned;
    EXPECT_NE(planned.find("--proposed 1"), std::string::npos) << planned;
    const auto before = run("diagnose " + study);
    EXPECT_EQ(before["verdict"], "unknown");
    EXPECT_TRUE(before["effects"].empty());
    ASSERT_FALSE(before["proposed"].empty());
    EXPECT_EQ(before["proposed"][0]["fits"], true);
    for (const auto& finding : before["scan"]) {
        EXPECT_NE(finding["decision"], "missing, with others") << finding["effect"];
    }
    const auto added = run("add " + study + " --proposed 1");
    EXPECT_GT(added["before"]["chi2"], 300);
    EXPECT_LT(added["after"]["chi2"], 110);  // 59 degrees of freedom
    const auto after = run("diagnose " + study);
    EXPECT_EQ(after["complete"], true);
    EXPECT_EQ(after["model_effects"], nlohmann::json({"torque-with-angular-velocity"}));
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

/// Diagnosis of the example `wet` after a change of one column of its recordings.
/// @param column index of the column
/// @param changed value, from that of the row and the share of the day's rows before it [1]
nlohmann::json diagnosis_of_changed(std::size_t column,
                                    const std::function<double(double, double)>& changed) {
    TemporaryFolder folder;
    const std::filesystem::path study = copied_example("wet", folder);
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(study))
        if (entry.path().extension() == ".csv") files.push_back(entry.path());
    std::ranges::sort(files);
    for (std::size_t k = 0; k < files.size(); ++k) {
        const std::string content = content_of(files[k]);
        std::istringstream recording(content);
        std::string text, line;
        std::getline(recording, line);
        text = line + '\n';
        while (std::getline(recording, line)) {
            std::size_t first = 0;
            for (std::size_t c = 0; c < column; ++c)
                first = line.find(',', first) + 1;
            const std::size_t last = line.find(',', first);
            const double share =
                static_cast<double>(text.size()) / static_cast<double>(content.size());
            const double before =
                (static_cast<double>(k) + share) / static_cast<double>(files.size());
            const double value = std::stod(line.substr(first, last - first));
            text += line.substr(0, first) + fmt::format("{:.7g}", changed(value, before)) +
                    line.substr(last) + '\n';
        }
        std::ofstream(files[k]) << text;
    }
    const Outcome outcome = run_pendular("diagnose " + study.string() + " --quiet --json -");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output);
}

/// Diagnosis of the example `wet` recorded by a torque transducer that shows T(1 - T/scale), less
/// the larger the torque T is; `scale` [mN m].
nlohmann::json diagnosis_with_weak_transducer(double scale) {
    return diagnosis_of_changed(
        1, [&](double torque, double) { return torque * (1 - torque / scale); });
}

// With a constant offset of the height the model passes its tests, but a drift is clearly better.
TEST(Proposals, OutdoAKnownEffectThatFits) {
    const auto diagnosis = diagnosis_of_changed(
        3, [](double gap, double before) { return gap * (1 + 0.02 * before); });
    EXPECT_EQ(diagnosis.at("verdict"), "unknown");
    EXPECT_TRUE(diagnosis.at("effects").empty());
    ASSERT_FALSE(diagnosis.at("proposed").empty());
    expect_told({diagnosis.at("proposed")[0].at("sentence").get<std::string>()});
    const auto outdone = [](const auto& finding) {
        return finding.at("decision") == "outdone by a change";
    };
    EXPECT_TRUE(std::ranges::any_of(diagnosis.at("scan"), outdone));
}

bool is_of_torque(const std::string& sentence) {
    return sentence.starts_with("The stress ratio") || sentence.starts_with("The shown torque");
}

TEST(Proposals, NameATransducerThatShowsLessTheLargerTheTorque) {
    const auto diagnosis = diagnosis_with_weak_transducer(800);  // 7.5 % less at 60 mN m
    for (const auto& finding : diagnosis.at("scan")) {
        const bool significant = finding.at("p").is_number() && finding.at("p") < 0.05;
        EXPECT_FALSE(significant && finding.at("decision") == "cannot be seen") << finding;
    }
    const auto& proposed = diagnosis.at("proposed");
    ASSERT_FALSE(proposed.empty());
    const auto sentence = proposed[0].at("sentence").get<std::string>();
    EXPECT_TRUE(is_of_torque(sentence)) << sentence;
    EXPECT_NE(sentence.find("in proportion to the normal stress"), std::string::npos) << sentence;
    EXPECT_EQ(sentence.find("Besides"), std::string::npos) << sentence;
    EXPECT_EQ(proposed[0].at("fits"), true);
}

TEST(Proposals, HaveNoNeedlessPart) {
    // So strong that no shape fits within the errors: the best pairs of shapes come with a second
    // one that is within two standard errors of no change.
    const auto diagnosis = diagnosis_with_weak_transducer(400);
    const auto& proposed = diagnosis.at("proposed");
    ASSERT_EQ(proposed.size(), 1u);
    const auto sentence = proposed[0].at("sentence").get<std::string>();
    EXPECT_TRUE(is_of_torque(sentence)) << sentence;
    EXPECT_EQ(sentence.find("Besides"), std::string::npos) << sentence;
    EXPECT_EQ(proposed[0].at("fits"), false);
    EXPECT_GT(proposed[0].at("explained"), 0.99);
}

TEST(Proposals, OfTwoChangesAreAsSignificantAsTheLesserOne) {
    const auto readings = readings_hiding(seal_drag(3e-4), 11);
    const Evidence evidence = evidence_of(readings, {});
    const DiagnosisOptions options;
    const Diagnosis diagnosis = diagnose(models(), evidence, options);
    const Explanations explanations(models(), evidence, options);
    const FittedModel& base = diagnosis.base;
    const ScoredShapes scored(planted_study(), models(), readings, base, explanations, 1);
    EXPECT_LT(scored.p(scored.singles().front()), 0.001);
    // One change is hidden, so that a second one only follows the noise.
    EXPECT_GT(scored.p(scored.pairs(1).front()), 0.001);
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
