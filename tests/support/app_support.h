#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>
#include <string>

#include "tests/support/golden.h"

using pendular::content_of;
using pendular::expect_told;

/// Result of a run of the `pendular` program: exit code, standard output and standard error.
struct Outcome {
    int code = -1;  ///< exit code; -1: the program was ended by a signal
    std::string output, errors;
};

/// Returns the path of the SQLite file for the simulation runs of tests, in a temporary folder of
/// this process. The first call also names the file in $PENDULAR_STORE, so that no test changes the
/// user's store.
inline const std::filesystem::path& test_store() {
    static const pendular::TemporaryFolder folder;
    static const std::filesystem::path file = [] {
        const auto path = folder.path() / "runs.sqlite";
        setenv("PENDULAR_STORE", path.c_str(), 1);
        return path;
    }();
    return file;
}

/// Runs the `pendular` program in a shell, as a user would.
/// @param words words after the program's name, as the shell reads them
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

/// Returns what is said of a simulation without the lines whose digits the simulation or a clock
/// decides: another processor may round otherwise.
inline std::string without_simulated(const std::string& told) {
    static const std::regex simulated(
        "^  |\\+-|computing time|averages over|the stress ratio above|cause a scatter");
    std::istringstream lines(told);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (!std::regex_search(line, simulated)) kept += line + "\n";
    return kept;
}

/// Expects that `pendular` refuses each of these commands (words after the program's name) with
/// exit code 2, in the golden words.
inline void expect_refused(const std::vector<std::string>& commands) {
    std::vector<std::string> transcript;
    for (const std::string& words : commands) {
        const Outcome run = run_pendular(words);
        EXPECT_EQ(run.code, 2) << words;
        transcript.push_back("$ pendular " + words + "\n" + run.errors);
    }
    expect_told(transcript);
}

/// Returns the JSON that `pendular` prints for a command, and expects that the command succeeds.
/// @param command words after the program's name, without --json
inline nlohmann::json json_of(const std::string& command) {
    const Outcome outcome = run_pendular(command + " --quiet --json -");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    return nlohmann::json::parse(outcome.output, nullptr, false);
}
