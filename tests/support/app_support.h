#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "tests/support/data_support.h"

inline std::string content_of(const std::filesystem::path& file) {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Result of a run of the real program.
struct Outcome {
    int code = -1;
    std::string output, errors;
};

/// A store of this process's own, so that no test touches the user's.
inline const std::filesystem::path& test_store() {
    static const pendular::TemporaryFolder folder;
    static const std::filesystem::path file = [] {
        const auto path = folder.path() / "runs.sqlite";
        setenv("PENDULAR_STORE", path.c_str(), 1);
        return path;
    }();
    return file;
}

/// Runs `pendular` with these words as a user's shell would.
inline Outcome run_pendular(const std::string& words) {
    test_store();
    const pendular::TemporaryFolder folder;
    const std::string command = std::string(PENDULAR_PROGRAM) + " " + words + " >" +
                                (folder.path() / "out").string() + " 2>" +
                                (folder.path() / "err").string();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content_of(folder.path() / "out"),
            content_of(folder.path() / "err")};
}

/// Expects that `pendular` calls these words wrong and says why.
inline void expect_refused(const std::string& words, const std::string& why) {
    const Outcome run = run_pendular(words);
    EXPECT_EQ(run.code, 2) << words;
    EXPECT_THAT(run.errors, testing::HasSubstr(why));
}
