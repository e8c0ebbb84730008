// `pendular add --confirm` stopped half-way by Ctrl-C, and given again.
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "sim/runs/store/run_store.h"
#include "tests/support/app_support.h"

using namespace pendular;
using testing::HasSubstr;
namespace fs = std::filesystem;

TEST(AddInterrupted, LeavesTheStudyAndGoesOnFromItsRuns) {
    const TemporaryFolder folder;
    const fs::path study = folder.path() / "study";
    fs::create_directory(study);
    // Emulated at friction 0.09, less 20 Pa of shear stress; fast flow, for the sake of time.
    std::ofstream(study / "points.csv")
        << "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction,"
           "solid_fraction_sd,inertial_number\n"
           "300,85.1,0.9,0.5985,0.0012,0.1\n"
           "1000,331.0,3.3,0.5992,0.0012,0.1\n"
           "3000,1028,10,0.5996,0.0012,0.1\n";
    std::ofstream(study / "study.toml") << R"([grains]
diameter = "500 um"
density = "1050 kg/m^3"
[cell]
inner_radius = "21 mm"
outer_radius = "45 mm"
bead_mass = "60 g"
[[readings]]
file = "points.csv"
liquid_content = 0
[model]
effects = []
)";
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
    EXPECT_THAT(content_of(errors), HasSubstr("give the same command again"));
    EXPECT_EQ(content_of(study / "study.toml"), before);
    EXPECT_FALSE(fs::exists(study / "out" / "ladder.json"));
    kept = RunStore(file).size();

    const Outcome again = run_pendular(words);
    EXPECT_EQ(again.code, 0) << again.errors;
    EXPECT_THAT(content_of(study / "study.toml"), HasSubstr("torque-offset"));
    EXPECT_TRUE(fs::exists(study / "out" / "ladder.json"));
    EXPECT_GT(RunStore(file).size(), kept);
}
