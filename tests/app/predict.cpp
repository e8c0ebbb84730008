// `pendular predict` and `pendular calibrate` on the emulator, as their users meet them.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tests/support/app_support.h"

namespace app_predict_test {

using nlohmann::json;
using pendular::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// The dry reading of Badetti et al. (2018) and its wet ones, as in examples/polystyrene.
Outcome calibrate_example(const TemporaryFolder& folder, const std::string& words) {
    fs::copy(PENDULAR_SOURCE_DIR "/examples/polystyrene", folder.path() / "study",
             fs::copy_options::recursive | fs::copy_options::skip_existing);
    return run_pendular(fmt::format("calibrate {} --fidelity quick --quiet --json - --out {} {}",
                                    (folder.path() / "study").string(), folder.path().string(),
                                    words));
}

TEST(Predict, TellsADryStateWithErrors) {
    const Outcome run = run_pendular("predict --friction 0.09 --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json said = json::parse(run.output);
    // Simulation of Badetti et al. (2018) in the quasi-static limit: 0.257 +- 0.002.
    EXPECT_NEAR(said["stress_ratio"]["value"], 0.257, 0.008);
    EXPECT_LT(said["stress_ratio"]["stderr"], 0.004);
    EXPECT_GT(said["stress_ratio"]["derivatives"]["friction"]["value"], 0.5);
    EXPECT_FALSE(said.contains("distant_force"));
    EXPECT_EQ(said["beyond"], "");
}

TEST(Predict, TellsAWetStateOfALiquidContent) {
    const Outcome run = run_pendular("predict --reduced-pressure 1 --liquid-content 0.03 --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json said = json::parse(run.output);
    EXPECT_NEAR(said["liquid_content"]["value"], 0.03, 0.0006);
    EXPECT_GT(said["stress_ratio"]["value"], 0.5);
    EXPECT_NEAR(said["distant_force"]["value"], 0.5, 0.06);  // over F0
    EXPECT_GT(said["bridge_volume"], 0.003);
}

TEST(Predict, AddsTheFormulasOfAWetState) {
    const Outcome run =
        run_pendular("predict --reduced-pressure 3 --bridge-volume 0.0006 --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json said = json::parse(run.output);
    const json& by = said["closures"];
    const double ratio = said["stress_ratio"]["value"], dry = by["dry_stress_ratio"];
    // Effective stress holds within 5 %; without the capillary shear stress the strength is too
    // high, and Rumpf's cohesion exceeds the generalised one by a^2 s12cap/F0 or so.
    EXPECT_NEAR(by["contact_stress_ratio"].get<double>() / dry, 1, 0.05);
    EXPECT_NEAR(by["strength1"].get<double>() / ratio, 1, 0.05);
    EXPECT_NEAR(by["strength2"].get<double>() / ratio, 1, 0.05);
    EXPECT_GT(by["strength3"], by["strength2"].get<double>() + 0.02);
    EXPECT_NEAR(by["rumpf_cohesion"].get<double>() - by["generalised_cohesion"].get<double>(),
                3 * said["capillary_shear_stress"]["value"].get<double>(), 0.02);
    EXPECT_NEAR(by["effective_coordination"], said["effective_coordination"]["value"], 0.05);
    const double content = said["liquid_content"]["value"],
                 fraction = said["solid_fraction"]["value"];
    EXPECT_NEAR(by["saturation"], content * fraction / (1 - fraction), 1e-9);
    EXPECT_FALSE(json::parse(run_pendular("predict --json -").output).contains("closures"));
}

TEST(Predict, DrawsAnyObservableAndFormula) {
    const TemporaryFolder folder;
    const std::string out = " --points 5 --out " + folder.path().string();
    const Outcome run = run_pendular(
        "predict --along reduced-pressure=1:10 --liquid-content 0.03 --draw distant_coordination "
        "--draw rumpf_cohesion --draw strength2 --json -" +
        out);
    ASSERT_EQ(run.code, 0) << run.errors;
    const json said = json::parse(run.output);
    // A curve has the formulas that each of its states has alone.
    const double pressure = said["states"][2]["reduced_pressure"];
    const json alone = json::parse(
        run_pendular(
            fmt::format("predict --reduced-pressure {} --liquid-content 0.03 --json -", pressure))
            .output);
    for (const auto& [name, value] : alone["closures"].items()) {
        EXPECT_NEAR(said["states"][2]["closures"][name].get<double>(), value.get<double>(), 1e-6)
            << name;
    }
    EXPECT_THAT(content_of(folder.path() / "prediction.csv"),
                HasSubstr(",rumpf_cohesion,generalised_cohesion,saturation\n"));
    const std::string drawn = content_of(folder.path() / "figures/prediction.svg");
    EXPECT_THAT(drawn, HasSubstr("distant coordination"));
    EXPECT_THAT(drawn, HasSubstr("reduced cohesion by Rumpf"));
    EXPECT_THAT(drawn, testing::Not(HasSubstr("solid fraction")));
    expect_refused({"predict --along friction=0:0.3 --draw strength2" + out,
                    "predict --along friction=0:0.3 --draw solid_fractio" + out,
                    "predict --draw stress_ratio"});
}

TEST(Simulate, AddsTheFormulasOfAWetState) {
    const std::string small =
        "simulate --quiet --fidelity quick --beads 200 --strain 1 --friction 0.09 "
        "--inertial-number 0.05 --json - ";
    const Outcome run = run_pendular(small + "--reduced-pressure 2 --bridge-volume 0.002");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json said = json::parse(run.output), by = said["closures"];
    const auto value = [&](const char* name) { return said[name]["value"].get<double>(); };
    // From the averages of the run itself, and the dry law of the known runs.
    const json dry =
        json::parse(run_pendular("predict --friction 0.09 --inertial-number 0.05 --json -").output);
    const double law = by["dry_stress_ratio"];
    EXPECT_NEAR(law, dry["stress_ratio"]["value"].get<double>(), 1e-6);
    EXPECT_NEAR(by["approximate_coordination"],
                value("contact_coordination") + 0.5 * value("distant_coordination"), 1e-6);
    EXPECT_NEAR(by["strength1"],
                law * (1 - value("capillary_stress_22")) - value("capillary_shear_stress"), 1e-6);
    EXPECT_NEAR(by["contact_stress_ratio"],
                (value("stress_ratio") + value("capillary_shear_stress")) /
                    (1 - value("capillary_stress_22")),
                1e-6);
    EXPECT_THAT(run.errors, HasSubstr("reduced cohesion by Eq. (24), Rumpf"));
    EXPECT_FALSE(json::parse(run_pendular(small).output).contains("closures"));
    // With an effect on dry grains too, there is no dry law.
    const Outcome rolling =
        run_pendular(small + "--reduced-pressure 2 --rolling-resistance.coefficient 0.1");
    EXPECT_FALSE(json::parse(rolling.output).contains("closures"));
    expect_told({without_simulated(rolling.errors)});
}

/// The command of a message that begins with these words.
std::string command_in(const std::string& message, const std::string& words) {
    const auto begin = message.find("    pendular " + words);
    return begin == std::string::npos
               ? ""
               : message.substr(begin + 13, message.find('\n', begin) - begin - 13);
}

TEST(Predict, RefusesWhatRunsDoNotSupportAndSaysWhatToDo) {
    const Outcome run =
        run_pendular("predict --friction 0.9 --reduced-pressure 0.1 --liquid-content 0.03");
    EXPECT_EQ(run.code, 2);
    EXPECT_EQ(run.output, "");
    expect_told({run.errors});
    // Both commands can be pasted; the first answers.
    const std::string near = command_in(run.errors, "predict ");
    EXPECT_EQ(run_pendular(near).code, 0) << near;
    // A state that cannot be simulated either: only the prediction of the nearest one is offered.
    const Outcome absurd =
        run_pendular("predict --friction 0.9 --reduced-pressure 0.02 --liquid-content 0.2");
    EXPECT_EQ(absurd.code, 2);
    expect_told({absurd.errors});
    EXPECT_EQ(command_in(absurd.errors, "simulate "), "");
}

TEST(Predict, SimulatesOnRequestWhatRunsDoNotSupport) {
    const TemporaryFolder folder;
    const std::string words =
        "predict --friction 0.3 --inertial-number 0.4 --simulate --fidelity quick --json - "
        "--store " +
        (folder.path() / "runs.sqlite").string();
    const Outcome run = run_pendular(words);
    ASSERT_EQ(run.code, 0) << run.errors;
    const json simulated = json::parse(run.output);
    EXPECT_EQ(simulated["simulated"], true);
    EXPECT_THAT(run.errors, HasSubstr("Simulated at quick fidelity"));
    // Faster than I = 0.1 the stress ratio is higher, and flow more dilute.
    const json slower = json::parse(
        run_pendular("predict --friction 0.3 --inertial-number 0.1 --json - --fidelity quick")
            .output);
    EXPECT_GT(simulated["stress_ratio"]["value"], slower["stress_ratio"]["value"]);
    EXPECT_LT(simulated["solid_fraction"]["value"], slower["solid_fraction"]["value"]);
    // The run is kept: the same state is supported now.
    const Outcome again = run_pendular(words);
    EXPECT_EQ(json::parse(again.output)["simulated"], false);
    expect_told({without_simulated(again.errors)});
    expect_refused({"predict --simulate --along friction=0:0.3"});
}

TEST(Predict, LeavesOutThePartOfACurveThatRunsDoNotSupport) {
    const TemporaryFolder folder;
    const std::string out = " --points 20 --out " + folder.path().string();
    const Outcome run = run_pendular(
        "predict --along reduced-pressure=0.1:10 --bridge-volume 0.002 --json -" + out);
    ASSERT_EQ(run.code, 0) << run.errors;
    const json said = json::parse(run.output);
    // 0.1 x 100^(k/19) is at least 0.5 from k = 7 on.
    EXPECT_EQ(said["left_out"], 7);
    EXPECT_EQ(said["states"].size(), 13u);
    expect_told({run.errors});
    EXPECT_EQ(std::ranges::count(content_of(folder.path() / "prediction.csv"), '\n'), 14);
    expect_refused({"predict --along friction=0.8:0.9" + out});
}

TEST(Predict, AnswersWithinTheSupportedRangeOnly) {
    // Corners and middle of the range of the atlas.
    for (const std::string friction : {"0", "0.09", "0.6"}) {
        for (const std::string number : {"0", "0.1"}) {
            for (const std::string wet : {"", " --reduced-pressure 0.5 --bridge-volume 0.008",
                                          " --reduced-pressure 50 --bridge-volume 0.0005"}) {
                const Outcome run = run_pendular("predict --json - --friction " + friction +
                                                 " --inertial-number " + number + wet);
                ASSERT_EQ(run.code, 0) << run.errors;
                const json said = json::parse(run.output);
                EXPECT_GT(said["stress_ratio"]["value"], 0.05);
                EXPECT_GT(said["solid_fraction"]["value"], 0.4);
                EXPECT_LT(said["solid_fraction"]["value"], 0.74);
            }
        }
    }
}

TEST(Predict, DrawsACurve) {
    const TemporaryFolder folder;
    const Outcome run = run_pendular(
        "predict --along reduced-pressure=0.5:20 --liquid-content 0.03 "
        "--points 12 --inertial-number 0.003 --out " +
        folder.path().string());
    ASSERT_EQ(run.code, 0) << run.errors;
    const std::string table = content_of(folder.path() / "prediction.csv");
    EXPECT_THAT(table, testing::StartsWith("friction,inertial_number,reduced_pressure"));
    EXPECT_EQ(std::ranges::count(table, '\n'), 13);
    EXPECT_TRUE(fs::exists(folder.path() / "figures" / "prediction.png"));
}

TEST(Predict, RefusesWhatIsNoState) {
    expect_refused(
        {"predict --friction -0.1", "predict --inertial-number 2", "predict --reduced-pressure 1",
         "predict --bridge-volume 0.001", "predict --reduced-pressure -1 --bridge-volume 0.001",
         "predict --along reduced-pressure=1e-300:1e300 --liquid-content 0.03",
         "predict --along reduced-pressure=1e-300:1e-299 --liquid-content 0.03",
         "predict --along friction=0:0.3 --points 1000000000", "predict --along frition=0:1",
         "predict --along friction=0.3", "predict --along friction=0.3:0.1",
         "predict --along friction=0:2", "predict --along inertial-number=0.01:0.1x"});
    const TemporaryFolder folder;
    const fs::path bad = folder.write("atlas.csv", "friction\n0.1\n");
    setenv("PENDULAR_ATLAS", bad.c_str(), 1);
    expect_refused({"predict"});
    unsetenv("PENDULAR_ATLAS");
}

TEST(Calibrate, AnswersFromTheAtlasAtOnce) {
    const TemporaryFolder folder;
    const Outcome run = calibrate_example(folder, "--no-confirm");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json fit = json::parse(run.output);
    EXPECT_NEAR(fit["parameters"]["friction"]["value"], 0.09, 0.02);
    EXPECT_EQ(fit["emulator"]["runs_ordered"].size(), 0u);
    EXPECT_EQ(fit, json::parse(content_of(folder.path() / "fit.json")));
}

/// A study of dry points, each a row of normal stress, stress ratio, solid fraction and inertial
/// number.
fs::path points_study(const TemporaryFolder& folder, const std::string& rows,
                      const std::string& model) {
    folder.write("points.csv",
                 "normal_stress [Pa],stress_ratio [1],stress_ratio_sd,"
                 "solid_fraction [1],solid_fraction_sd,inertial_number [1]\n" +
                     rows);
    folder.write("study.toml", pendular::grains_table + model + pendular::points_table);
    return folder.path();
}

TEST(Calibrate, NamesReadingsThatRunsDoNotSupport) {
    const TemporaryFolder folder;
    const Outcome run = run_pendular(
        "calibrate --no-confirm --quiet " +
        points_study(folder, "1000,0.27,0.005,0.615,0.001,0.003\n1000,0.6,0.02,0.55,0.002,0.3\n",
                     "")
            .string());
    ASSERT_EQ(run.code, 0) << run.errors;
    expect_told({run.output});
}

TEST(Calibrate, SaysThatAnEffectAtItsNeutralBoundIsNotNeeded) {
    // Adhesion raises the stress ratio where the normal stress is low; here it falls there.
    const TemporaryFolder folder;
    const std::string study =
        points_study(folder,
                     "300,0.24,0.003,0.612,0.001,0.003\n1000,0.26,0.003,0.612,0.001,0.003\n"
                     "3000,0.27,0.003,0.612,0.001,0.003\n",
                     "[model]\neffects = [\"dry-adhesion\"]\n")
            .string();
    const Outcome run = run_pendular("calibrate --no-confirm --quiet " + study);
    expect_told({run.output});
}

}  // namespace app_predict_test
