// Every command of docs/tutorial/hidden-effect.md, in its order, on a copy of the example.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/app_support.h"

namespace tutorial_test {

using namespace pendular;
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
    std::vector<std::string> transcript;
    for (const std::string& command : all) {
        const Outcome outcome =
            run_pendular(replaced(command, "examples/hidden-effect", study) + " --quiet");
        ASSERT_EQ(outcome.code, 0) << command << "\n" << outcome.errors;
        transcript.push_back("$ pendular " + command + "\n" + outcome.output);
    }
    expect_told(transcript);
    EXPECT_TRUE(fs::exists(fs::path(study) / "out/figures/ladder.png"));
}

}  // namespace tutorial_test
