// `pendular diagnose --confirm`: a verdict confirmed by simulations, within its time, and stopped
// half-way by Ctrl-C.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <nlohmann/json.hpp>
#include <thread>

#include "sim/runs/store/run_store.h"
#include "tests/support/app_support.h"
#include "tests/support/drag_study.h"

namespace pendular::physics_diagnose_confirmed_test {

namespace fs = std::filesystem;

class DiagnoseConfirmed : public testing::Test {
  protected:
    DiagnoseConfirmed() { write_drag_study(study_); }
    std::string words(const std::string& minutes) const {
        return "diagnose " + study_.string() + " --confirm " + minutes +
               " --fidelity quick --quiet --json - --store " + store_.string();
    }
    static nlohmann::json confirmed(const Outcome& outcome) {
        return nlohmann::json::parse(outcome.output)["confirmed"];
    }

    TemporaryFolder folder_;
    const fs::path study_ = folder_.path() / "study", store_ = folder_.path() / "runs.sqlite";
};

TEST_F(DiagnoseConfirmed, EndsWhereItsVerdictIsFirm) {
    const Outcome none = run_pendular(words("0"));
    ASSERT_EQ(none.code, 0) << none.errors;
    EXPECT_EQ(confirmed(none)["runs"], 0);
    EXPECT_EQ(confirmed(none)["settled"], false);
    const Outcome firm = run_pendular(words("20"));
    ASSERT_EQ(firm.code, 0) << firm.errors;
    EXPECT_GE(confirmed(firm)["runs"], 4);
    EXPECT_EQ(confirmed(firm)["settled"], true) << confirmed(firm);
    EXPECT_LT(confirmed(firm)["seconds"], 1200);
    EXPECT_EQ(RunStore(store_).size(), confirmed(firm)["runs"].get<std::size_t>());
}

TEST_F(DiagnoseConfirmed, GoesOnFromItsRunsAfterCtrlC) {
    const std::string errors = (folder_.path() / "err").string();
    const std::string command =
        std::string("exec ") + PENDULAR_PROGRAM + " " + words("20") + " >/dev/null 2>" + errors;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
        execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
        _exit(127);
    }
    std::size_t kept = 0;
    for (int wait = 0; wait < 3000 && kept == 0; ++wait) {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        if (fs::exists(store_)) kept = RunStore(store_).size();
    }
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_GT(kept, 0u);
    EXPECT_EQ(WEXITSTATUS(status), 130);
    expect_told({content_of(errors)});
    EXPECT_FALSE(fs::exists(study_ / "out" / "diagnosis.json"));
    kept = RunStore(store_).size();

    const Outcome again = run_pendular(words("20"));
    ASSERT_EQ(again.code, 0) << again.errors;
    EXPECT_EQ(RunStore(store_).size(), kept + confirmed(again)["runs"].get<std::size_t>());
}

}  // namespace pendular::physics_diagnose_confirmed_test
