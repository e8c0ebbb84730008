// The program as its users meet it: exit codes, messages, JSON, interruption.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "tests/support/app_support.h"

namespace app_program_test {

using pendular::TemporaryFolder;
using testing::HasSubstr;

const std::string grains = pendular::grains_table, cell = pendular::cell_table("20 g");
const std::string recording = "[[recording]]\nfile = \"run.csv\"\n";
const std::string header = pendular::recording_header;

/// A study whose only recording is broken in one place.
Outcome import_with(const std::string& table, const std::string& toml = grains + cell + recording) {
    const TemporaryFolder folder;
    folder.write("study.toml", toml);
    folder.write("run.csv", table);
    return run_pendular("import " + folder.path().string());
}

std::string rows(int count, const std::string& torque = "12.5", int from = 0) {
    std::string text;
    for (int k = from; k < from + count; ++k) {
        text += std::to_string(k) + "," + torque + ",5.0,6.2,1.1\n";
    }
    return text;
}

TEST(Simulate, PrintsJsonAloneOnStandardOutput) {
    const Outcome run = run_pendular(
        "simulate --beads 100 --stiffness-number 300 --inertial-number 0.05 --strain 1 --friction "
        "0.2 --seed 7 --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    for (const std::string key :
         {"stress_ratio", "solid_fraction", "contact_coordination", "distant_coordination",
          "liquid_content", "distant_force", "capillary_stress_22", "capillary_shear_stress",
          "capillary_shear_stress_contact", "capillary_shear_stress_distant", "fabric_12_contact",
          "fabric_12_distant", "localization", "first_normal_stress_difference",
          "second_normal_stress_difference"}) {
        EXPECT_TRUE(json.at(key).contains("value") && json.at(key).contains("stderr")) << key;
    }
    for (const std::string key :
         {"grain_steps_per_second", "particle_steps_per_second", "wall_seconds", "steps",
          "time_step", "strain_averaged", "crystallised", "steady", "seed"}) {
        EXPECT_TRUE(json.contains(key)) << key;
    }
    EXPECT_EQ(json["seed"], 7);
    EXPECT_GT(json["stress_ratio"]["value"], 0.1);
    EXPECT_THAT(run.errors, HasSubstr("stress ratio"));  // the verdict moved aside
}

TEST(Simulate, JoinsBeadsByBridges) {
    const Outcome run = run_pendular(
        "simulate --beads 100 --stiffness-number 300 --inertial-number 0.05 --strain 1 "
        "--reduced-pressure 2 --bridge-volume 0.012 --bridge-force as_printed --quiet --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    const auto value = [&](const char* key) { return json.at(key).at("value").get<double>(); };
    EXPECT_NEAR(value("liquid_content"),
                3 / std::numbers::pi * 0.012 *
                    (value("contact_coordination") + value("distant_coordination")),
                1e-9);
    EXPECT_LT(value("capillary_stress_22"), -0.3);  // attraction, over s22
    EXPECT_GT(value("capillary_shear_stress_contact"), 0);
    EXPECT_LT(value("capillary_shear_stress_distant"), 0);
    EXPECT_GT(value("distant_force"), 0.3);  // over F0
    EXPECT_LT(value("distant_force"), 0.8);
    EXPECT_EQ(json["bridge_force"], "as_printed");
    expect_told({without_simulated(run.errors)});
}

TEST(Simulate, StopsCleanlyWhenInterrupted) {
    const TemporaryFolder folder;
    const std::string json = (folder.path() / "run.json").string();
    const std::string command = std::string("timeout -s INT 3 ") + PENDULAR_PROGRAM +
                                " simulate --strain 500 --quiet --json " + json + " 2>" +
                                (folder.path() / "err").string();
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 124);  // timeout's own code: the program ended at its signal
    expect_told({content_of(folder.path() / "err")});
    EXPECT_FALSE(std::filesystem::exists(json));
}

TEST(BadInput, IsAnsweredWithFileLineColumnAndExitCode2) {
    for (const std::string& table :
         {std::string("Time [s],Torque [mN m],Gap [mm],Angular velocity [rad/s]\n0,1,6,1\n"),
          "Time [s],Torque [mN blorp],Normal force [N],Gap [mm],Angular velocity [rad/s]\n" +
              rows(30),
          header + rows(3) + "3,twelve,5.0,6.2,1.1\n" + rows(30, "12.5", 4),
          header + "0,\"12,5\",5,6.2,1.1\n", std::string(),
          header + rows(3) + "3,inf,5.0,6.2,1.1\n" + rows(30, "12.5", 4),
          header + rows(40) + rows(40, "-12.5", 40)}) {
        const Outcome outcome = import_with(table);
        EXPECT_EQ(outcome.code, 2) << table;
        EXPECT_EQ(outcome.output, "") << table;
        expect_told({outcome.errors});
    }
}

TEST(BadInput, InTheStudyIsAnsweredAtItsLine) {
    const std::string swapped =
        "[cell]\ninner_radius = \"45 mm\"\nouter_radius = \"21 mm\"\nbead_mass = \"20 g\"\n";
    const Outcome radii = import_with(header + rows(30), grains + swapped + recording);
    EXPECT_EQ(radii.code, 2);
    expect_told({radii.errors});
    const Outcome key =
        import_with(header + rows(30), "[grains]\ndiametre = \"500 um\"\n" + cell + recording);
    EXPECT_EQ(key.code, 2);
    expect_told({key.errors});
}

TEST(BadInput, OfWetStudiesIsAnsweredWithTheReason) {
    const Outcome dry =
        import_with(header + rows(40), grains + cell + recording + "liquid_content = 0.03\n");
    EXPECT_EQ(dry.code, 2);
    expect_told({dry.errors});

    const TemporaryFolder folder;
    folder.write(
        "points.csv",
        "normal_stress [Pa],stress_ratio [1],solid_fraction [1],inertial_number [1],"
        "liquid_content [1]\n300,0.4,0.6,0,0.03\n300,0.5,0.6,0,0.2\n300,0.3,0.6,0,0.0005\n");
    folder.write("study.toml",
                 grains +
                     "[liquid]\nsurface_tension = \"20.6 mN/m\"\ncontact_angle = \"0 deg\"\n"
                     "[[readings]]\nfile = \"points.csv\"\n");
    const Outcome wet = run_pendular("import " + folder.path().string());
    EXPECT_EQ(wet.code, 3);  // more readings are set aside than kept
    expect_told({wet.output + wet.errors});
    // Nothing dry to fit, and the way out.
    const Outcome fit = run_pendular("calibrate --quiet " + folder.path().string());
    EXPECT_EQ(fit.code, 2);
    expect_told({fit.errors});
}

TEST(Import, WritesReadingsAndWhatItLeftOut) {
    const TemporaryFolder folder;
    const std::string out = folder.path().string();
    const Outcome outcome = run_pendular(
        "import " PENDULAR_SOURCE_DIR "/examples/dry-recordings --json - --out " + out);
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    const auto json = nlohmann::json::parse(outcome.output);
    EXPECT_EQ(json["readings"].size(), 9u);
    EXPECT_EQ(json["excluded"].size(), 9u);  // the start of every step
    const std::string table = content_of(folder.path() / "readings.csv");
    expect_told({table.substr(0, table.find('\n')), json["excluded"][0]["reason"]});
    EXPECT_EQ(std::ranges::count(content_of(folder.path() / "excluded.csv"), '\n'), 10);
    for (const auto& reading : json["readings"]) {
        EXPECT_NEAR(
            reading["shear_stress"]["value"].get<double>() / reading["normal_stress"].get<double>(),
            0.2929, 4 * 0.04 * 0.2929);
        EXPECT_NEAR(reading["inertial_number"].get<double>(), 0.003, 1e-4);
    }
}

TEST(Compare, AsksForACalibrationFirst) {
    const TemporaryFolder folder;
    const Outcome outcome = run_pendular(
        "compare " PENDULAR_SOURCE_DIR "/examples/polystyrene --out " + folder.path().string());
    EXPECT_EQ(outcome.code, 2);
    expect_told({outcome.errors});
}

}  // namespace app_program_test
