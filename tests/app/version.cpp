// What `pendular --version` says of the build, and what a new version takes over from former ones.
#include <ceres/version.h>
#include <gtest/gtest.h>

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "tests/support/app_support.h"

namespace app_version_test {

using pendular::TemporaryFolder;
using testing::HasSubstr;

/// Line on the atlas of this folder.
std::string atlas_line(const std::filesystem::path& folder) {
    const std::string command = std::string("PENDULAR_ATLAS=") + (folder / "atlas.csv").string() +
                                " " PENDULAR_PROGRAM " --version >" + (folder / "told").string();
    EXPECT_EQ(std::system(command.c_str()), 0);
    const std::string told = content_of(folder / "told");
    return told.substr(told.find("Atlas: "));
}

TEST(Version, NamesTheCompilerAndTheLibraries) {
    const std::string told = run_pendular("--version").output;
    EXPECT_THAT(told, HasSubstr("Ceres " CERES_VERSION_STRING ","));
    EXPECT_THAT(told, HasSubstr("Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." +
                                std::to_string(EIGEN_MAJOR_VERSION) + "." +
                                std::to_string(EIGEN_MINOR_VERSION) + ","));
    EXPECT_THAT(told, HasSubstr(__VERSION__));
    // A library whose variable CMake does not set has no number.
    EXPECT_THAT(told, testing::Not(testing::ContainsRegex("[a-z+] (,|\n)")));
}

// 64-bit FNV-1a, computed by hand for one byte: (basis xor 'a') times the prime modulo 2^64.
TEST(Version, HashesSimulationsAndHyperparametersOfTheAtlas) {
    const TemporaryFolder folder;
    folder.write("atlas.csv", "a");
    EXPECT_EQ(atlas_line(folder.path()),
              "Atlas: hash af63dc4c8601ec8c, " + (folder.path() / "atlas.csv").string() + "\n");
    folder.write("emulator.csv", "b");
    EXPECT_THAT(atlas_line(folder.path()), testing::Not(HasSubstr("af63dc4c8601ec8c")));
}

TEST(Version, DoesNotFailWithoutAnAtlas) {
    const TemporaryFolder folder;
    EXPECT_THAT(atlas_line(folder.path()), HasSubstr("atlas.csv"));
}

// The name of a program that the shell found is no path: an atlas beside it would be one of the
// working folder.
TEST(Version, TakesNoAtlasOfTheWorkingFolder) {
    const TemporaryFolder folder;
    for (const char* place : {"atlas", "share/pendular"}) {
        std::filesystem::create_directories(folder.path() / place);
        folder.write(std::string(place) + "/atlas.csv", "broken");
    }
    const std::filesystem::path program = PENDULAR_PROGRAM;
    const auto told = [&](const std::string& command) {
        const std::string whole =
            "cd " + folder.path().string() + " && unset PENDULAR_ATLAS && " + command + " >told";
        EXPECT_EQ(std::system(whole.c_str()), 0);
        const std::string text = content_of(folder.path() / "told");
        return text.substr(text.find("Atlas: "));
    };
    const std::string by_name = told("PATH=" + program.parent_path().string() + ":$PATH " +
                                     program.filename().string() + " --version");
    EXPECT_THAT(by_name, testing::Not(HasSubstr(" atlas/atlas.csv")));
    EXPECT_EQ(by_name, told(program.string() + " --version"));
}

// The stores were written by the versions that their names state: two simulations, friction 0.1
// and 0.3.
TEST(FormerStores, AreRead) {
    const TemporaryFolder folder;
    int stores = 0;
    for (const auto& file :
         std::filesystem::directory_iterator(PENDULAR_SOURCE_DIR "/tests/data/stores")) {
        const auto copy = folder.path() / file.path().filename();
        std::filesystem::copy(file.path(), copy);
        const auto runs = json_of("runs list --store " + copy.string())["runs"];
        ASSERT_EQ(runs.size(), 2) << file.path();
        EXPECT_EQ(runs[0]["friction"], 0.1);
        EXPECT_EQ(runs[1]["friction"], 0.3);
        EXPECT_NEAR(runs[0]["stress_ratio"]["value"], 0.323, 0.0005);
        ++stores;
    }
    EXPECT_GE(stores, 1);
}

}  // namespace app_version_test
