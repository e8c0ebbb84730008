// A result is repeated to the last bit with the simulations that it rests on (--runs-of), whatever
// the store holds by then.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/support/app_support.h"

namespace app_runs_of_test {

using nlohmann::json;
using pendular::TemporaryFolder;
namespace fs = std::filesystem;

class RunsOf : public testing::Test {
  protected:
    RunsOf() {
        folder_.write("points.csv",
                      "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction "
                      "[1],solid_fraction_sd [1],inertial_number [1]\n"
                      "300,66.91,0.77,0.6189,0.0012,0.003\n1000,233.82,2.56,0.6198,0.0012,0.003\n"
                      "3000,720.66,7.67,0.6203,0.0012,0.003\n300,74.98,0.85,0.6138,0.0012,0.03\n"
                      "1000,266.67,2.84,0.6127,0.0012,0.03\n3000,801.46,8.53,0.6141,0.0012,0.03\n");
        folder_.write("study.toml",
                      pendular::grains_table + pendular::points_table + "liquid_content = 0.0\n");
    }
    std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
    std::string with_store() const { return " --store " + path("runs.sqlite"); }
    json result(const std::string& words) const {
        return json_of(words + " --fidelity quick" + with_store());
    }
    /// Another run of the store, with nothing to do with the study; 1000 beads train the emulator.
    void simulate_something() const {
        const Outcome run = run_pendular(
            "simulate --quiet --beads 1000 --stiffness-number 1000 --inertial-number 0.1 --strain "
            "1 "
            "--friction 0.13 --seed 5" +
            with_store());
        ASSERT_EQ(run.code, 0) << run.errors;
    }

    const TemporaryFolder folder_;
};

TEST_F(RunsOf, RepeatsAFitAndADiagnosisToTheLastBit) {
    const std::string study = folder_.path().string();
    const std::string fit = "calibrate " + study + " --no-confirm", look = "diagnose " + study;
    const json first = result(fit), verdict = result(look);
    fs::copy(path("out/fit.json"), path("first.json"));
    fs::copy(path("out/diagnosis.json"), path("verdict.json"));
    simulate_something();
    const json other = result(fit);
    EXPECT_EQ(other["runs"]["number"], first["runs"]["number"].get<int>() + 1);
    EXPECT_NE(other["runs"]["hash"], first["runs"]["hash"]);
    EXPECT_NE(other["parameters"], first["parameters"]);
    EXPECT_EQ(result(fit + " --runs-of " + path("first.json")), first);
    EXPECT_NE(result(look)["parameters"], verdict["parameters"]);
    EXPECT_EQ(result(look + " --runs-of " + path("verdict.json")), verdict);
}

TEST_F(RunsOf, CountsTheRunsThatAreGone) {
    simulate_something();
    result("predict --friction 0.12");
    const json known = result("predict --friction 0.12");
    folder_.write("known.json", known.dump());
    fs::remove(path("runs.sqlite"));
    expect_refused({"predict --friction 0.12 --runs-of " + path("known.json") + with_store()});
    simulate_something();  // another wall time, which belongs to the results of a run
    folder_.write("other.json", "{\"friction\": 1}");
    expect_refused({"predict --friction 0.12 --runs-of " + path("other.json") + with_store()});
}

}  // namespace app_runs_of_test
