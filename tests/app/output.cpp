// What `pendular simulate` writes besides averages, as its users meet it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <thread>

#include "tests/support/app_support.h"

namespace app_output_test {

using pendular::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;
using nlohmann::json;

const std::string small_run =
    "simulate --quiet --beads 100 --stiffness-number 300 --inertial-number 0.05 --strain 1 "
    "--friction 0.2 --seed 7 ";
/// Some seconds of work.
const std::string longer_run =
    "simulate --quiet --beads 150 --stiffness-number 300 --inertial-number 0.01 --strain 8 "
    "--friction 0.2 --seed 7 ";

/// Runs the program and sends it a signal once it has written that checkpoint.
Outcome interrupted_at(const fs::path& checkpoint, const std::string& words) {
    const TemporaryFolder folder;
    const std::string command = fmt::format(
        "{} {} --checkpoint {} >/dev/null 2>{} & while kill -0 $! && ! test -s {}; do sleep 0.02; "
        "done 2>/dev/null; kill -INT $!; wait $!",
        PENDULAR_PROGRAM, words, checkpoint.string(), (folder.path() / "err").string(),
        checkpoint.string());
    const int status = std::system(("bash -c '" + command + "'").c_str());
    return {WEXITSTATUS(status), "", content_of(folder.path() / "err")};
}

/// A result without what differs between two processes.
json without_times(const std::string& text) {
    json result = json::parse(text);
    result.erase("wall_seconds");
    result.erase("grain_steps_per_second");
    result.erase("particle_steps_per_second");
    return result;
}

TEST(Simulate, SaysWhatItsProfilesAndDistributionsAre) {
    const Outcome run = run_pendular(small_run + "--json - --reduced-pressure 4");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json result = json::parse(run.output);
    for (const std::string part : {"friction", "viscosity", "bridges", "springs"}) {
        EXPECT_GE(result.at("dissipation_" + part).at("value").get<double>(), 0) << part;
    }
    for (const std::string name : {"velocity", "solid_fraction", "granular_temperature"}) {
        const json& field = result.at("profiles").at(name);
        EXPECT_EQ(field.at("coordinate").at("name"), "height");
        EXPECT_EQ(field.at("at").size(), field.at("value").size());
        EXPECT_EQ(field.at("at").size(), field.at("stderr").size());
        EXPECT_FALSE(field.at("meaning").get<std::string>().empty());
    }
    const json& distributions = result.at("distributions");
    EXPECT_EQ(distributions.at("contact_orientation").at("value").size(), 36u);
    EXPECT_EQ(distributions.at("contact_orientation").at("unit"), "1/rad");
    EXPECT_TRUE(distributions.contains("distant_orientation"));
    EXPECT_TRUE(distributions.contains("distant_gap"));
    EXPECT_THAT(run.errors, HasSubstr("dissipation_friction"));
}

TEST(Simulate, WritesFilesOnlyWhereAskedTo) {
    const TemporaryFolder folder;
    const std::string there = folder.path().string();
    const fs::path here = fs::current_path();
    fs::current_path(folder.path());
    EXPECT_EQ(run_pendular(small_run).code, 0);
    fs::current_path(here);
    EXPECT_TRUE(fs::is_empty(folder.path()));

    const Outcome run = run_pendular(small_run + "--snapshot-every 0.5 --out " + there);
    ASSERT_EQ(run.code, 0) << run.errors;
    for (const std::string name :
         {"run.json", "profiles.csv", "orientations.csv", "contact_forces.csv", "beads.dump",
          "snapshots.pvd", "vtk/beads_00000.vtp", "vtk/pairs_00001.vtp", "figures/profiles.png",
          "figures/distributions.pdf"}) {
        EXPECT_TRUE(fs::exists(folder.path() / name)) << name;
    }
    EXPECT_FALSE(fs::exists(folder.path() / "gaps.csv"));  // dry
    EXPECT_THAT(content_of(folder.path() / "profiles.csv"),
                HasSubstr("height [1],velocity [1],velocity_sd [1],solid_fraction [1]"));
    EXPECT_TRUE(json::parse(content_of(folder.path() / "run.json")).contains("distributions"));
}

TEST(Simulate, ResumesWhatWasInterrupted) {
    const TemporaryFolder folder;
    const fs::path checkpoint = folder.path() / "run.checkpoint";
    const std::string kept = longer_run + "--checkpoint " + checkpoint.string() + " --json ";
    const Outcome first =
        interrupted_at(checkpoint, longer_run + "--checkpoint-every 0.001 --json " +
                                       (folder.path() / "no.json").string());
    EXPECT_EQ(first.code, 130);
    ASSERT_TRUE(fs::exists(checkpoint));
    EXPECT_FALSE(fs::exists(folder.path() / "no.json"));

    const Outcome other = run_pendular(small_run + "--checkpoint " + checkpoint.string());
    EXPECT_EQ(other.code, 2);
    expect_told({first.errors, other.errors});

    const Outcome second = run_pendular(kept + "-");
    ASSERT_EQ(second.code, 0) << second.errors;
    EXPECT_EQ(without_times(second.output),
              without_times(run_pendular(longer_run + "--json -").output));
    EXPECT_TRUE(fs::is_empty(folder.path()));  // neither checkpoint nor lock
}

TEST(Simulate, RefusesACheckpointThatAnotherProcessUses) {
    const TemporaryFolder folder;
    const fs::path checkpoint = folder.path() / "run", pid = folder.path() / "pid";
    const std::string words =
        "simulate --quiet --beads 100 --strain 500 --checkpoint " + checkpoint.string();
    ASSERT_EQ(
        std::system(fmt::format("{} {} >/dev/null 2>&1 & echo $! >{}; while ! test -e {}.lock; do "
                                "sleep 0.02; done",
                                PENDULAR_PROGRAM, words, pid.string(), checkpoint.string())
                        .c_str()),
        0);
    const Outcome second = run_pendular(words);
    EXPECT_EQ(second.code, 2);
    EXPECT_THAT(second.errors, HasSubstr("is using it"));
    ASSERT_EQ(std::system(("kill -INT $(cat " + pid.string() + ")").c_str()), 0);
    while (!fs::exists(checkpoint) || fs::exists(folder.path() / "run.lock")) {
        // until the first has put its run down
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
}

TEST(Simulate, KeepsItsCheckpointWhenTheDiskIsFull) {
    const TemporaryFolder folder;
    const fs::path checkpoint = folder.path() / "run";
    const std::string kept = longer_run + "--checkpoint " + checkpoint.string();
    ASSERT_EQ(interrupted_at(checkpoint, longer_run + "--checkpoint-every 0.001").code, 130);
    const std::string before = content_of(checkpoint);
    const std::string command =
        "trap '' XFSZ; ulimit -f 8; unset PENDULAR_STORE XDG_DATA_HOME; HOME=/dev/null exec " +
        std::string(PENDULAR_PROGRAM) + " " + kept +
        " --checkpoint-every 0.0001 2>&1 | head -c 2000 >" + (folder.path() / "err").string();
    ASSERT_EQ(std::system(("bash -c \"" + command + "\"").c_str()), 0);
    EXPECT_THAT(content_of(folder.path() / "err"), HasSubstr("former checkpoint is still there"));
    EXPECT_EQ(content_of(checkpoint), before);
}

TEST(Simulate, NamesWhatIsMissingForItsFiles) {
    std::vector<std::string> commands;
    for (const std::string words :
         {"--snapshot-every 0.1", "--snapshot-every 0.001 --out /tmp", "--checkpoint-every 5",
          "--checkpoint x --checkpoint-every 0", "--checkpoint /dev/full",
          "--checkpoint /proc/nowhere", "--threads 100000"})
        commands.push_back("simulate --quiet --beads 64 " + words);
    expect_refused(commands);
}

}  // namespace app_output_test
