// `pendular add --confirm` stopped half-way by Ctrl-C, and given again.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "sim/runs/store/run_store.h"
#include "tests/support/app_support.h"
#include "tests/support/drag_study.h"

using namespace pendular;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(AddInterrupted, LeavesTheStudyAndGoesOnFromItsRuns) {
    const TemporaryFolder folder;
    const fs::path study = folder.path() / "study";
    write_drag_study(study);
    const std::string before = content_of(study / "study.toml");
    const fs::path file = folder.path() / "runs.sqlite";
    const std::string words = "add " + study.string() +
                              " torque-offset --confirm --fidelity quick --quiet --store " +
                              file.string();

    // Once the first of its runs is kept, it is stopped.
    const std::string errors = (folder.path() / "err").string();
    const std::string command =
        std::string("exec ") + PENDULAR_PROGRAM + " " + words + " >/dev/null 2>" + errors;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    std::size_t kept = 0;
    for (int wait = 0; wait < 1200 && kept == 0; ++wait) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        if (fs::exists(file)) kept = RunStore(file).size();
    }
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_GT(kept, 0u);
    EXPECT_EQ(WEXITSTATUS(status), 130);
    expect_told({content_of(errors)});
    EXPECT_EQ(content_of(study / "study.toml"), before);
    EXPECT_FALSE(fs::exists(study / "out" / "ladder.json"));
    kept = RunStore(file).size();

    const Outcome again = run_pendular(words);
    EXPECT_EQ(again.code, 0) << again.errors;
    EXPECT_THAT(content_of(study / "study.toml"), HasSubstr("torque-offset"));
    EXPECT_TRUE(fs::exists(study / "out" / "ladder.json"));
    EXPECT_GT(RunStore(file).size(), kept);
}
