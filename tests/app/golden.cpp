// What the program says, whole: each file of tests/golden/terminal is the transcript of a user's
// terminal. A line that begins with "$ " is a command, the lines below it are what it printed, and
// [2] is an exit code other than 0. Commands run in a folder of their own that holds copies of the
// examples.
//
// A new case is a line with its command. Where a simulation or a random number decides digits, the
// command replaces them with sed, as another processor may round otherwise.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/app_support.h"

namespace app_golden_test {

using pendular::TemporaryFolder;

const std::filesystem::path source = PENDULAR_SOURCE_DIR;
const std::filesystem::path transcripts = pendular::golden_texts / "terminal";

/// Copies of all examples, and a shell that finds the program and nobody's stored runs.
class Terminal {
  public:
    Terminal() {
        std::filesystem::copy(source / "examples", folder_.path() / "home",
                              std::filesystem::copy_options::recursive);
    }

    /// Output of a command, standard output and errors in one, and its exit code if it is not 0.
    std::string run(const std::string& command) const {
        const auto script = folder_.write("command.sh", command + "\n");
        const auto printed = folder_.path() / "printed";
        const std::string shell =
            "cd " + (folder_.path() / "home").string() +
            " && env -u PENDULAR_STORE NO_COLOR=1 COLUMNS=100 XDG_DATA_HOME=" +
            (folder_.path() / "data").string() +
            " PATH=" + std::filesystem::path(PENDULAR_PROGRAM).parent_path().string() +
            ":$PATH bash " + script.string() + " >" + printed.string() + " 2>&1";
        const int status = std::system(shell.c_str());
        std::string text = content_of(printed);
        if (!text.empty() && text.back() != '\n') text += '\n';
        const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return code == 0 ? text : text + "[" + std::to_string(code) + "]\n";
    }

  private:
    TemporaryFolder folder_;
};

/// The transcript of the commands of another, run again.
std::string run_again(const std::string& transcript) {
    const Terminal terminal;
    std::istringstream lines(transcript);
    std::string again;
    bool begun = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("$ ")) {
            again += (begun ? "\n" : "") + line + "\n" + terminal.run(line.substr(2));
            begun = true;
        }
    }
    return again;
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const auto& file : std::filesystem::directory_iterator(transcripts)) {
        all.push_back(file.path().stem().string());
    }
    std::sort(all.begin(), all.end());
    return all;
}

class Transcripts : public testing::TestWithParam<std::string> {};

TEST_P(Transcripts, SayTheSame) {
    const auto file = transcripts / (GetParam() + ".txt");
    const std::string before = content_of(file), now = run_again(before);
    pendular::expect_same_text(before, now, file, now);
}

INSTANTIATE_TEST_SUITE_P(Of, Transcripts, testing::ValuesIn(names()), [](const auto& transcript) {
    std::string name = transcript.param;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
});

}  // namespace app_golden_test
