// `pendular predict` and `pendular calibrate` on the emulator, as their users meet them.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app_support.h"

namespace app_predict_test {

using nlohmann::json;
using pendular::TemporaryFolder;
using testing::HasSubstr;
namespace fs = std::filesystem;

/// The source's dry reading and its wet ones, as in examples/polystyrene.
Outcome calibrate_example(const TemporaryFolder& folder, const std::string& words) {
    fs::copy(PENDULAR_SOURCE_DIR "/examples/polystyrene", folder.path() / "study",
             fs::copy_options::recursive | fs::copy_options::skip_existing);
    return run_pendular(fmt::format("calibrate {} --fidelity quick --quiet --json - --out {} {}",
                                    (folder.path() / "study").string(), folder.path().string(),
                                    words));
}

TEST(Predict, TellsADryStateWithErrors) {
    const Outcome run = run_pendular("predict --friction 0.09 --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json said = json::parse(run.output);
    // The source's simulation in the quasi-static limit: 0.257 +- 0.002.
    EXPECT_NEAR(said["stress_ratio"]["value"], 0.257, 0.008);
    EXPECT_LT(said["stress_ratio"]["stderr"], 0.004);
    EXPECT_GT(said["stress_ratio"]["by"]["friction"]["value"], 0.5);
    EXPECT_FALSE(said.contains("distant_force"));
    EXPECT_EQ(said["beyond"], "");
}

TEST(Predict, TellsAWetStateOfALiquidContent) {
    const Outcome run = run_pendular("predict --reduced-pressure 1 --liquid-content 0.03 --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json said = json::parse(run.output);
    EXPECT_NEAR(said["liquid_content"]["value"], 0.03, 0.0006);
    EXPECT_GT(said["stress_ratio"]["value"], 0.5);
    EXPECT_NEAR(said["distant_force"]["value"], 0.5, 0.06);  // over F0
    EXPECT_GT(said["bridge_volume"], 0.003);
}

TEST(Predict, SaysWhereItExtrapolates) {
    const Outcome run = run_pendular("predict --reduced-pressure 0.1 --bridge-volume 0.004");
    EXPECT_EQ(run.code, 0);
    EXPECT_THAT(run.output + run.errors,
                HasSubstr("extrapolated: reduced pressure 0.1 is below 0.5"));
}

TEST(Predict, DrawsACurve) {
    const TemporaryFolder folder;
    const Outcome run = run_pendular(
        "predict --along reduced-pressure=0.5:20 --liquid-content 0.03 "
        "--points 12 --inertial-number 0.003 --out " +
        folder.path().string());
    ASSERT_EQ(run.code, 0) << run.errors;
    const std::string table = content_of(folder.path() / "prediction.csv");
    EXPECT_THAT(table, testing::StartsWith("friction,inertial_number,reduced_pressure"));
    EXPECT_EQ(std::ranges::count(table, '\n'), 13);
    EXPECT_TRUE(fs::exists(folder.path() / "figures" / "prediction.png"));
}

TEST(Predict, RefusesWhatIsNoState) {
    expect_refused("predict --friction -0.1", "--friction -0.1");
    expect_refused("predict --inertial-number 2", "0 to 0.5 is needed");
    expect_refused("predict --reduced-pressure 1", "either --bridge-volume or --liquid-content");
    expect_refused("predict --bridge-volume 0.001", "need --reduced-pressure");
    expect_refused("predict --reduced-pressure -1 --bridge-volume 0.001", "a positive number");
    expect_refused("predict --along frition=0:1", "did you mean 'friction'");
    expect_refused("predict --along friction=0.3", "as in friction=0.5:10");
    expect_refused("predict --along friction=0.3:0.1", "the lesser first");
    expect_refused("predict --along friction=0:2", "--friction 2");
    expect_refused("predict --along inertial-number=0.01:0.1x", "two numbers");
    const TemporaryFolder folder;
    const fs::path bad = folder.write("atlas.csv", "friction\n0.1\n");
    setenv("PENDULAR_ATLAS", bad.c_str(), 1);
    expect_refused("predict", "atlas.csv:1:1");
    unsetenv("PENDULAR_ATLAS");
}

TEST(Calibrate, AnswersFromTheAtlasAtOnce) {
    const TemporaryFolder folder;
    const Outcome run = calibrate_example(folder, "--no-confirm");
    ASSERT_EQ(run.code, 0) << run.errors;
    const json fit = json::parse(run.output);
    EXPECT_NEAR(fit["parameters"]["friction"]["value"], 0.09, 0.02);
    EXPECT_EQ(fit["emulator"]["runs_ordered"].size(), 0u);
    EXPECT_EQ(fit, json::parse(content_of(folder.path() / "fit.json")));
}

}  // namespace app_predict_test
