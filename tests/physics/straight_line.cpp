// examples/straight-line, as docs/tutorial/straight-line.md has it: a straight line in 1/P*, what
// it misses, and the levels from there to the simulation.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "tests/support/app_support.h"

namespace straight_line_test {

using namespace pendular;
using testing::ElementsAre;
namespace fs = std::filesystem;

/// By how much shear stress is over-predicted on average over readings of a normal stress [Pa].
double overestimate(const nlohmann::json& compared, double normal_stress) {
    double sum = 0, count = 0;
    for (const auto& condition : compared.at("by_condition")) {
        if (condition.at("liquid_content") == 0 ||
            std::abs(condition.at("normal_stress").get<double>() / normal_stress - 1) > 0.02) {
            continue;
        }
        for (const auto& reading : condition.at("readings")) {
            sum += reading.at("predicted").at("shear_stress").at("value").get<double>() /
                       reading.at("measured").at("shear_stress").at("value").get<double>() -
                   1;
            ++count;
        }
    }
    return sum / count;
}

TEST(StraightLine, FailsAtSmallPressuresAndTheLadderLeadsToTheSimulation) {
    const TemporaryFolder folder;
    const std::string path = copied_example("straight-line", folder).string();
    const auto fit = json_of("calibrate " + path + " --no-confirm");
    const auto friction = fit.at("parameters").at("friction");
    EXPECT_NEAR(friction.at("value"), 0.12, 3 * friction.at("stderr").get<double>());

    // The line is right where it was fitted and too high below; two cohesions take two degrees of
    // freedom of the 48 wet values.
    const auto line = json_of("compare " + path);
    EXPECT_LT(std::abs(overestimate(line, 777)), 0.015);
    EXPECT_GT(overestimate(line, 77.7), 0.04);
    EXPECT_EQ(line.at("dof"), 57);

    const auto diagnosis = json_of("diagnose " + path);
    EXPECT_EQ(diagnosis.at("verdict"), "missing");
    EXPECT_THAT(diagnosis.at("effects"), ElementsAre("contact-stress"));

    // No number is fitted on the levels above, and each is better than the one below.
    double before = INFINITY;
    for (const std::string level :
         {"rumpf-cohesion", "distant-bridge-force", "capillary-shear-stress",
          "capillary-normal-stress", "contact-stress"}) {
        const auto change = json_of("add " + path + " " + level);
        const double after = change.at("after").at("chi2");
        EXPECT_LT(after, before) << level;
        EXPECT_EQ(change.at("after").at("dof"), 59);
        before = after;
    }
    EXPECT_LT(before, 90);  // 59 degrees of freedom
    const auto full = json_of("compare " + path);
    EXPECT_LT(std::abs(overestimate(full, 77.7)), 0.02);
    EXPECT_THAT(json_of("diagnose " + path).at("verdict").get<std::string>(),
                testing::AnyOf("nothing-missing", "inconclusive"));
}

}  // namespace straight_line_test
