// What the program says, whole: texts that tests compare live in tests/golden, one file for each
// file of tests. A section of such a file begins with "== SUITE.TEST" and holds what this test was
// told. A change of wording is one difference to look at, and scripts/accept_golden.sh accepts it.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include "tests/support/data_support.h"

namespace pendular {

inline const std::filesystem::path golden_texts =
    std::filesystem::path(PENDULAR_SOURCE_DIR) / "tests/golden";

/// Returns the content of a file; empty where the file does not exist.
inline std::string content_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
}

/// Expects that a text is the golden one. With $PENDULAR_ACCEPT_GOLDEN the text becomes the golden
/// one: `file` is written with `accepted`.
inline void expect_same_text(const std::string& golden, const std::string& now,
                             const std::filesystem::path& file, const std::string& accepted) {
    if (golden == now) return;
    if (std::getenv("PENDULAR_ACCEPT_GOLDEN")) {
        std::filesystem::create_directories(file.parent_path());
        std::ofstream(file) << accepted;
        return;
    }
    const TemporaryFolder folder;
    const auto difference = folder.path() / "difference";
    const std::string command = "diff -u --label " + file.string() + " --label now " +
                                folder.write("golden", golden).string() + " " +
                                folder.write("now", now).string() + " >" + difference.string();
    EXPECT_GE(std::system(command.c_str()), 0);
    ADD_FAILURE() << content_of(difference)
                  << "\nIf this is what the program is to say: scripts/accept_golden.sh, or "
                     "accept_reference.sh for a page of docs";
}

/// Returns a text with FOLDER in place of temporary folders and SOURCE in place of the project's.
inline std::string without_paths(const std::string& text) {
    const std::regex folder(std::filesystem::temp_directory_path().string() +
                            "/pendular_[0-9]+_[0-9]+");
    return std::regex_replace(std::regex_replace(text, folder, "FOLDER"),
                              std::regex(PENDULAR_SOURCE_DIR), "SOURCE");
}

/// Expects that the running test is told these texts and no others, one after the other. Sections
/// of further calls in one test are numbered.
inline void expect_told(const std::vector<std::string>& texts) {
    const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
    const std::filesystem::path source = test.file();
    const auto file = golden_texts / source.parent_path().filename() / source.stem().concat(".txt");
    const auto number = std::to_string(test.result()->test_property_count() + 1);
    testing::Test::RecordProperty("told_" + number, "");
    const std::string heading = std::string("== ") + test.test_suite_name() + "." + test.name() +
                                (number == "1" ? "" : " " + number) + "\n";
    std::string now = heading;
    for (const std::string& text : texts)
        now += without_paths(text) + (text.ends_with('\n') ? "" : "\n");
    const std::string all = content_of(file);
    const std::size_t begin = std::min(all.find(heading), all.size());
    const std::size_t next = all.find("\n== ", begin);
    const std::size_t end = next == std::string::npos ? all.size() : next + 1;
    expect_same_text(all.substr(begin, end - begin), now, file,
                     all.substr(0, begin) + now + all.substr(end));
}

}  // namespace pendular
