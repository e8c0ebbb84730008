#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "data/annular_cell.h"
#include "data/grains.h"
#include "tests/support/app_support.h"

namespace app_diagnose_test {

using namespace pendular;

/// Dry readings as of friction 0.09, shear stresses short by a constant that a tare could be.
class DiagnoseCommand : public testing::Test {
  protected:
    std::string study(const std::string& points, double upper = 200) {
        std::ofstream(folder_.path() / "points.csv")
            << "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction "
               "[1],solid_fraction_sd [1],inertial_number [1]\n"
            << points;
        std::ofstream(folder_.path() / "study.toml")
            << grains_table << points_table
            << "liquid_content = 0.0\n"
               "[[effect]]\nname = \"lost-stress\"\nparameter = \"stress\"\nunit = \"Pa\"\n"
               "lower = -200.0\nupper = "
            << upper
            << "\nneutral = 0.0\nmatters = 10.0\n"
               "stress_ratio = \"stress_ratio - stress/normal_stress\"\n";
        return folder_.path().string();
    }
    TemporaryFolder folder_;
};

/// Emulated at friction 0.09, less 20 Pa of shear stress, with errors of 1 % and 0.0012.
const std::string short_by_20_pascals =
    "300,56.91,0.77,0.6189,0.0012,0.003\n"
    "1000,233.82,2.56,0.6198,0.0012,0.003\n"
    "3000,750.66,7.67,0.6203,0.0012,0.003\n"
    "300,64.98,0.85,0.6138,0.0012,0.03\n"
    "1000,266.67,2.84,0.6127,0.0012,0.03\n"
    "3000,831.46,8.53,0.6141,0.0012,0.03\n";

TEST_F(DiagnoseCommand, NamesAnEffectThatTheStudyWrites) {
    const std::string path = study(short_by_20_pascals);
    const Outcome run = run_pendular("diagnose " + path + " --quiet --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_THAT(json.at("effects"), testing::Contains("lost-stress")) << run.errors;
    for (const char* key : {"verdict", "confidence_set", "lack_of_fit_p", "chi2", "dof"})
        EXPECT_TRUE(json.contains(key)) << key;
    for (const auto& row : json.at("scan"))
        for (const char* key :
             {"effect", "predicted_reduction", "predicted_drop", "estimate", "share_imitated",
              "absorbed", "power", "p", "decision", "refitted_reduction", "refit_drop"})
            EXPECT_TRUE(row.contains(key)) << key;
    for (const auto& row : json.at("scan")) {  // former names, until format 3
        EXPECT_EQ(row.at("predicted_drop"), row.at("predicted_reduction"));
        EXPECT_EQ(row.at("refit_drop"), row.at("refitted_reduction"));
        EXPECT_EQ(row.at("absorbed"), row.at("share_imitated"));
    }
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / "diagnosis.json"));
}

TEST_F(DiagnoseCommand, SaysWhereTheBoundOfAWrittenEffectStopsIt) {
    const std::string path = study(short_by_20_pascals, 0.02);
    const Outcome run = run_pendular("diagnose " + path + " --quiet");
    ASSERT_EQ(run.code, 0) << run.errors;
    expect_told({run.output + run.errors});
}

/// Readings as emulated at friction 0.09, and points of failure with 1.2 times the shear stress.
TEST_F(DiagnoseCommand, NamesThePeakStrengthOfPointsOfFailure) {
    const std::string path = study(
        "300,76.91,0.77,0.6189,0.0012,0.003\n"
        "1000,253.82,2.56,0.6198,0.0012,0.003\n"
        "3000,770.66,7.67,0.6203,0.0012,0.003\n"
        "300,84.98,0.85,0.6138,0.0012,0.03\n"
        "1000,286.67,2.84,0.6127,0.0012,0.03\n"
        "3000,851.46,8.53,0.6141,0.0012,0.03\n");
    folder_.write("failure.csv",
                  "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction "
                  "[1],solid_fraction_sd [1],inertial_number [1]\n"
                  "300,92.29,0.92,0.61,0.1,0.003\n"
                  "1000,304.58,3.05,0.61,0.1,0.003\n"
                  "3000,924.79,9.25,0.61,0.1,0.003\n");
    std::ofstream(folder_.path() / "study.toml", std::ios::app)
        << "[[readings]]\nfile = \"failure.csv\"\nstate = \"failure\"\nliquid_content = 0.0\n";
    const Outcome compared = run_pendular("import " + path + " --all");
    expect_told({compared.output});
    const Outcome run = run_pendular("diagnose " + path + " --quiet --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_EQ(json.at("verdict"), "missing") << run.errors;
    EXPECT_EQ(json.at("effects"), nlohmann::json({"peak-strength"})) << run.errors;
    const Outcome added = run_pendular("add " + path + " peak-strength --quiet --json -");
    ASSERT_EQ(added.code, 0) << added.errors;
    const auto change = nlohmann::json::parse(added.output);
    const auto fit = nlohmann::json::parse(content_of(folder_.path() / "out" / "fit.json"));
    const auto& factor = fit.at("parameters").at("peak-strength.factor");
    EXPECT_NEAR(factor.at("value").get<double>(), 1.2, 4 * factor.at("stderr").get<double>());
    EXPECT_LT(factor.at("stderr").get<double>(), 0.05);
    EXPECT_LT(change.at("after").at("chi2").get<double>(),
              0.1 * change.at("before").at("chi2").get<double>());
}

TEST_F(DiagnoseCommand, OffersPeakStrengthOnlyForPointsOfFailure) {
    const std::string path = study("300,76.91,0.77,0.6189,0.0012,0.003\n");
    const Outcome run = run_pendular("effects peak-strength --study " + path);
    expect_told({run.output + run.errors});
}

TEST_F(DiagnoseCommand, SaysWhatCannotBeDiagnosed) {
    const std::string path = study(
        "300,79,0.8,0.5995,0.0012,0.003\n"
        "300,78,0.8,0.5995,0.0012,0.003\n");
    const Outcome run = run_pendular("diagnose --quiet " + path);
    EXPECT_EQ(run.code, 2);
    expect_told({run.errors});
}

TEST_F(DiagnoseCommand, SaysWhatToMeasureNext) {
    const std::string path = study(
        "300,79.1,0.8,0.6189,0.0012,0.003\n"
        "1000,258.0,2.6,0.6198,0.0012,0.003\n"
        "3000,774.0,7.7,0.6203,0.0012,0.003\n"
        "300,86.5,0.9,0.6138,0.0012,0.03\n"
        "1000,286.0,2.9,0.6127,0.0012,0.03\n"
        "3000,855.0,8.6,0.6141,0.0012,0.03\n");
    std::ofstream(folder_.path() / "study.toml", std::ios::app)
        << "[rig]\nnormal_stress = [\"0.2 kPa\", \"5 kPa\"]\ninertial_number = [0.003, 0.03]\n";
    const Outcome run = run_pendular("next " + path + " --quiet --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_GE(json.at("point").at("normal_stress"), 200);
    EXPECT_TRUE(json.contains("rivals"));
    EXPECT_TRUE(json.contains("repeats"));
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / "next.json"));
}

TEST_F(DiagnoseCommand, ListsTheStepsWhereNoReadingCanBePlanned) {
    const std::string path = study(
        "300,79.1,0.8,0.6189,0.0012,0.003\n"
        "1000,258.0,2.6,0.6198,0.0012,0.003\n"
        "3000,774.0,7.7,0.6203,0.0012,0.003\n");
    // No simulation has such an inertial number.
    std::ofstream(folder_.path() / "study.toml", std::ios::app)
        << "[rig]\nnormal_stress = \"1 kPa\"\ninertial_number = 3\n";
    const Outcome run = run_pendular("next --quiet " + path);
    EXPECT_EQ(run.code, 0) << run.errors;
    expect_told({run.output + run.errors});
    std::ifstream written(folder_.path() / "out" / "next.json");
    const auto json = nlohmann::json::parse(written);
    EXPECT_FALSE(json.contains("point"));
    expect_told({json.at("to_do").dump(1)});
}

TEST_F(DiagnoseCommand, RefusesARigThatCannotBe) {
    const std::string path = study("300,79.1,0.8,0.6189,0.0012,0.003\n");
    std::ofstream(folder_.path() / "study.toml", std::ios::app)
        << "[rig]\nnormal_stress = \"2 kg\"\ninertial_number = 0.01\n";
    const Outcome run = run_pendular("next --quiet " + path);
    EXPECT_EQ(run.code, 2);
    expect_told({run.errors});
}

/// Readings with a rolling resistance of 0.02, all at one inertial number.
struct Point {
    double normal_stress, shear_stress, solid_fraction;
};
const std::vector<std::vector<Point>> rolling_beads = {
    {{1000, 395.2, 0.572}, {2500, 991.5, 0.571}, {5000, 1986, 0.572}},
    {{1000, 399.8, 0.571}, {2500, 998.7, 0.573}, {5000, 1979, 0.571}}};
const GrainProperties heavy_beads{.diameter = 500e-6, .density = 2500};
const std::string heavy_beads_table =
    "[grains]\ndiameter = \"500 um\"\ndensity = \"2500 kg/m^3\"\n";

/// Recording of an annular cell with 60 g of beads that shows points one after the other.
std::string recording_of(const std::vector<Point>& points) {
    const AnnularCell cell{
        .inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 0.06 / heavy_beads.density};
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::string text = recording_header;
    double time = 0;
    for (const Point& point : points) {
        const double gap = height(point.solid_fraction, cell);
        const double rate = 0.004 / inertial_number(1, point.normal_stress, heavy_beads);
        for (int row = 0; row < 400; ++row)
            text += fmt::format(
                "{:.4f},{:.6g},{:.6g},{:.6g},{:.6g}\n", time += 0.05 / rate,
                1e3 * torque(point.shear_stress, cell) * (1 + 0.01 * normal(random)),
                normal_force(point.normal_stress, cell) * (1 + 0.002 * normal(random)),
                1e3 * gap * (1 + 5e-4 * normal(random)), angular_velocity(rate, gap, cell));
    }
    return text;
}

TEST_F(DiagnoseCommand, DoubtsNoSpeedInATableWithoutSpeeds) {
    std::string points =
        "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction "
        "[1],solid_fraction_sd [1],inertial_number [1]\n";
    for (const auto& filling : rolling_beads)
        for (const Point& point : filling)
            points +=
                fmt::format("{},{},{},{},0.002,0.004\n", point.normal_stress, point.shear_stress,
                            0.01 * point.shear_stress, point.solid_fraction);
    folder_.write("points.csv", points);
    folder_.write("study.toml", heavy_beads_table + points_table);
    const Outcome run = run_pendular("diagnose " + folder_.path().string() + " --quiet --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_EQ(json.at("verdict"), "missing");
    EXPECT_THAT(json.at("effects"), testing::ElementsAre("rolling-resistance"));
}

TEST_F(DiagnoseCommand, PrefersAKnownEffectToAWrongUnit) {
    // Multiplying the speeds by 9.549 leaves a chi2 of 9, the effect one of 5.
    folder_.write("dry_1.csv", recording_of(rolling_beads[0]));
    folder_.write("dry_2.csv", recording_of(rolling_beads[1]));
    folder_.write("study.toml",
                  heavy_beads_table + cell_table() + "[[recording]]\nfile = \"dry_*.csv\"\n");
    const Outcome run = run_pendular("diagnose " + folder_.path().string() + " --quiet --json -");
    ASSERT_EQ(run.code, 0) << run.errors;
    const auto json = nlohmann::json::parse(run.output);
    EXPECT_EQ(json.at("verdict"), "missing");
    EXPECT_THAT(json.at("effects"), testing::ElementsAre("rolling-resistance"));
}

}  // namespace app_diagnose_test
