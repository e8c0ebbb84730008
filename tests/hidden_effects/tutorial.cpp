// Every command of docs/tutorial/hidden-effect.md, in its order, on a copy of the example.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/app_support.h"

namespace tutorial_test {

using namespace pendular;
using testing::HasSubstr;
namespace fs = std::filesystem;

const fs::path example = fs::path(PENDULAR_SOURCE_DIR) / "examples/hidden-effect";

/// Lines that begin with the program's name, without it.
std::vector<std::string> commands() {
    std::ifstream file(fs::path(PENDULAR_SOURCE_DIR) / "docs/tutorial/hidden-effect.md");
    std::vector<std::string> found;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("pendular ")) {
            found.push_back(line.substr(9));
        }
    }
    return found;
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    const auto at = text.find(what);
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}

TEST(Tutorial, DoesWhatItSays) {
    const TemporaryFolder folder;
    const std::string study = (folder.path() / "hidden-effect").string();
    fs::copy(example, study, fs::copy_options::recursive);
    fs::remove(fs::path(study) / "truth.json");
    const auto all = commands();
    ASSERT_EQ(all.size(), 10u);
    std::map<std::string, std::vector<std::string>> said;
    for (const std::string& command : all) {
        const Outcome outcome =
            run_pendular(replaced(command, "examples/hidden-effect", study) + " --quiet");
        ASSERT_EQ(outcome.code, 0) << command << "\n" << outcome.errors;
        said[command.substr(0, command.find(' '))].push_back(outcome.output);
    }
    EXPECT_THAT(said["import"][0], HasSubstr("24 readings written to"));
    EXPECT_THAT(said["calibrate"][0],
                HasSubstr("Do not use the fitted intergranular friction coefficient, 0.19"));
    EXPECT_THAT(said["compare"][0], HasSubstr("residual of the shear stress (measured minus model) "
                                              "increases with the normal stress"));
    EXPECT_THAT(said["diagnose"][0], HasSubstr("Missing: wall-friction (coefficient 0.1483"));
    EXPECT_THAT(said["effects"][0], HasSubstr("Janssen"));
    EXPECT_THAT(said["add"][0],
                HasSubstr("wall-friction added: chi2/dof falls from 15.04 to 0.95"));
    EXPECT_THAT(said["compare"][1],
                HasSubstr("chi2 = 46.5 for 49 degrees of freedom (p = 0.57)"));
    EXPECT_THAT(said["diagnose"][1],
                HasSubstr("Inconclusive: the model describes the readings, but "));
    EXPECT_THAT(said["next"][0], HasSubstr("30 g of beads"));
    EXPECT_THAT(said["drop"][0], HasSubstr("wall-friction dropped"));
    EXPECT_TRUE(fs::exists(fs::path(study) / "out/figures/ladder.png"));
}

}  // namespace tutorial_test
