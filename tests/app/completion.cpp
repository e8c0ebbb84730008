// Completion for shells and manual pages hold every option of every command's --help.
// tests/manual tries them in the shells.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

#include "app/manual/manual.h"
#include "tests/support/app_support.h"

namespace app_completion_test {

using namespace pendular::app;
using testing::HasSubstr;

/// Names of the options that a help text lists.
std::set<std::string> options_of(const std::string& help) {
    const std::regex option("\n  --([a-z._-]+)");
    std::set<std::string> names;
    for (std::sregex_iterator it(help.begin(), help.end(), option), end; it != end; ++it) {
        names.insert((*it)[1]);
    }
    return names;
}

TEST(Completion, KnowsEveryOptionOfEveryHelpText) {
    for (const DeclaredCommand& command : declared_commands()) {
        const auto names = options_of(run_pendular(command.name + " --help").output);
        // Every command shows these.
        ASSERT_TRUE(names.contains("json") && names.contains("help")) << command.name;
        const std::vector<DeclaredCommand> alone = {command};
        const std::string bash = bash_completion(alone), zsh = zsh_completion(alone),
                          fish = fish_completion(alone),
                          page = man_page_of(command, {"2026-01-01", "1"});
        for (const std::string& name : names) {
            EXPECT_THAT(bash,
                        testing::AnyOf(HasSubstr("--" + name + " "), HasSubstr("--" + name + "'")));
            EXPECT_THAT(
                zsh, testing::AnyOf(HasSubstr("'--" + name + "["), HasSubstr("'--" + name + "=[")));
            EXPECT_THAT(fish, HasSubstr("-l " + name + " -d"));
            EXPECT_THAT(page,
                        HasSubstr("\\fB\\-\\-" + std::regex_replace(name, std::regex("-"), "\\-")));
        }
        EXPECT_EQ(names.size(), command.options().size()) << command.name;
    }
}

TEST(ManPage, KeepsWhatRoffWouldTakeForItsOwn) {
    const DeclaredCommand command{
        "odd",
        "a summary",
        "Heading",
        {.usage = "odd FILE",
         .about = "Takes 'a' \\ b.\n.SH is no heading.\n  .a  first of a list\n  -b  its second\n",
         .examples = "  pendular odd ~/x^2 `y`\n"}};
    const std::string page = man_page_of(command, {"2026-01-01", "1.2"});
    expect_told({page});
}

}  // namespace app_completion_test
