// Options that all commands accept: the help text of a command shows those that it uses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "app/command.h"
#include "app/declaration.h"
#include "tests/support/app_support.h"

namespace app_common_options_test {

using pendular::TemporaryFolder;

const std::set<std::string> all = {"json", "out", "fidelity", "store", "threads", "quiet", "all"};

/// Common options that commands make no use of; the other commands use all of them.
const std::map<std::string, std::set<std::string>> unused = {
    {"import", {"fidelity", "store", "threads", "quiet"}},
    {"compare", {"fidelity", "store", "threads", "quiet"}},
    {"effects", {"out", "store", "threads", "quiet"}},
    {"predict", {"threads"}},
    {"campaign", {"out"}},
    {"runs", {"fidelity", "threads"}},
    {"virtual-lab", {"out", "store"}}};

std::set<std::string> of_command(const pendular::app::Command& command) {
    std::set<std::string> names;
    for (const auto& section : pendular::app::declaration_of(command.run).sections) {
        for (const auto& option : section.options) {
            if (all.contains(option.name)) names.insert(option.name);
        }
    }
    return names;
}

TEST(CommonOptions, AreInTheHelpOfTheCommandsThatUseThem) {
    for (const auto& group : pendular::app::command_groups()) {
        for (const auto& command : group.commands) {
            std::set<std::string> expected = all;
            if (const auto left_out = unused.find(std::string(command.name));
                left_out != unused.end()) {
                for (const std::string& name : left_out->second) {
                    expected.erase(name);
                }
            }
            EXPECT_EQ(of_command(command), expected) << command.name;
        }
    }
    const std::string help = run_pendular("runs --help").output;
    EXPECT_THAT(help, testing::Not(testing::HasSubstr("--fidelity")));
    EXPECT_THAT(help, testing::HasSubstr("--store FILE"));
}

// A script may give the same options to every command.
TEST(CommonOptions, AreAcceptedByEveryCommand) {
    const TemporaryFolder folder;
    const std::string options = " --fidelity quick --threads 1 --quiet --all --store " +
                                (folder.path() / "runs.sqlite").string() + " --out " +
                                folder.path().string();
    for (const std::string words : {"effects", "runs list --atlas", "predict --friction 0.1"}) {
        const Outcome run = run_pendular(words + options);
        EXPECT_EQ(run.code, 0) << words << run.errors;
    }
    expect_refused({"runs list --atlas --fidelity quik", "effects --threads 0"});
}

TEST(CommonOptions, ListTheFidelitiesOnePerLine) {
    const std::string help = run_pendular("simulate --help").output;
    for (const char* line : {"quick: 1000 grains", "standard: 2000 grains", "paper: 4000 grains"}) {
        EXPECT_THAT(help, testing::ContainsRegex(std::string("\n +") + line));
    }
}

}  // namespace app_common_options_test
