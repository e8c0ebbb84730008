// `pendular virtual-lab` as its users meet it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/app_support.h"

namespace app_virtual_lab_test {

using pendular::TemporaryFolder;

/// One fast step, a second of work.
const std::string one_step =
    " --fidelity quick --dry --dry-normal-stresses \"1 kPa\" --inertial-numbers 0.5 --replicates 1 "
    "--rows 200 --friction 0.4 --quiet ";

std::size_t entries(const std::filesystem::path& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

TEST(VirtualLabCommand, WritesAStudyThatImports) {
    const TemporaryFolder folder;
    const std::string lab = (folder.path() / "lab").string();
    const Outcome made = run_pendular("virtual-lab " + lab + one_step + "--json -");
    ASSERT_EQ(made.code, 0) << made.errors;
    expect_told({without_simulated(made.errors)});
    const auto truth = nlohmann::json::parse(made.output);
    EXPECT_EQ(truth["friction"], 0.4);
    EXPECT_EQ(nlohmann::json::parse(content_of(folder.path() / "lab" / "truth.json")), truth);
    const Outcome imported = run_pendular("import " + lab + " --json -");
    ASSERT_EQ(imported.code, 0) << imported.errors;
    const auto json = nlohmann::json::parse(imported.output);
    ASSERT_EQ(json["readings"].size(), 1u);
    // Noise of 1 %, six standard deviations at most.
    const double ratio = truth["recordings"][0]["steps"][0]["run"]["stress_ratio"]["value"];
    EXPECT_NEAR(json["readings"][0]["shear_stress"]["value"].get<double>() / (1000 * ratio), 1,
                0.06);
    EXPECT_EQ(entries(folder.path()), 1u);

    // Again, with the same seed, into a folder that is there but empty.
    std::filesystem::create_directory(folder.path() / "again");
    const Outcome again =
        run_pendular("virtual-lab " + (folder.path() / "again").string() + "/" + one_step);
    ASSERT_EQ(again.code, 0) << again.errors;
    EXPECT_EQ(content_of(folder.path() / "again" / "dry_1.csv"),
              content_of(folder.path() / "lab" / "dry_1.csv"));
    EXPECT_EQ(entries(folder.path() / "again"), 3u);
}

TEST(VirtualLabCommand, RefusesBeforeItSimulates) {
    const TemporaryFolder folder;
    folder.write("kept.txt", "mine");
    const std::string taken = folder.path().string();
    std::vector<std::string> commands = {"virtual-lab", "virtual-lab " + taken,
                                         "virtual-lab " + taken + "/kept.txt",
                                         "virtual-lab " + taken + "/kept.txt/lab"};
    for (const std::string option :
         {"--friction=-1", "--dry-normal-stresses \"1, 2\"", "--wet-normal-stresses \"1 mm\"",
          "--liquid-contents wet", "--bead-mass \"1 g, 2 g\"", "--surface-tension \"20 mN\"",
          "--replicates 0", "--dry --liquid-contents 0.01", "--out elsewhere", "--frction 0.1"})
        commands.push_back("virtual-lab " + taken + "/lab " + option);
    expect_refused(commands);
    EXPECT_EQ(entries(folder.path()), 1u);
}

TEST(VirtualLabCommand, LeavesNothingWhenInterrupted) {
    const TemporaryFolder folder;
    const std::string command = std::string("timeout --preserve-status -s INT 1 ") +
                                PENDULAR_PROGRAM + " virtual-lab " +
                                (folder.path() / "lab").string() + " --quiet 2>/dev/null";
    const int status = std::system(command.c_str());
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_EQ(entries(folder.path()), 0u);
}

TEST(VirtualLabExample, IsWhatItsTruthSays) {
    const std::string example = PENDULAR_SOURCE_DIR "/examples/wet";
    const TemporaryFolder folder;
    const Outcome imported =
        run_pendular("import " + example + " --json - --out " + folder.path().string());
    ASSERT_EQ(imported.code, 0) << imported.errors;
    const auto readings = nlohmann::json::parse(imported.output)["readings"];
    const auto truth = nlohmann::json::parse(content_of(example + "/truth.json"));
    std::vector<nlohmann::json> steps;
    for (const auto& recording : truth["recordings"]) {
        steps.insert(steps.end(), recording["steps"].begin(), recording["steps"].end());
    }
    ASSERT_EQ(readings.size(), steps.size());
    for (std::size_t k = 0; k < steps.size(); ++k) {
        const auto& run = steps[k]["run"];
        const double stress = readings[k]["shear_stress"]["value"];
        const double expected =
            run["stress_ratio"]["value"].get<double>() * readings[k]["normal_stress"].get<double>();
        // The instrument's 1 % and 0.2 %, 4.5 standard deviations: 1 in 1500 folders has such a
        // step among its 88 values by chance.
        EXPECT_NEAR(stress / expected, 1, 0.045) << k;
        EXPECT_NEAR(readings[k]["solid_fraction"]["value"].get<double>() /
                        run["solid_fraction"]["value"].get<double>(),
                    1, 0.009)
            << k;
    }
}

}  // namespace app_virtual_lab_test
