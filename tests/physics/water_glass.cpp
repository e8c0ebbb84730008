// examples/water-glass, command by command as its README has it: simulated recordings at constant
// speed in another cell, with an offset of the torque that a direct measurement settles.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

#include "tests/support/app_support.h"

namespace water_glass_test {

using namespace pendular;
using testing::Contains;
using testing::ElementsAre;
namespace fs = std::filesystem;

/// Cohesions [Pa] of readings and model, with the square of the error of their difference.
struct Cohesions {
    double readings = 0, model = 0, variance = 0;
};

Cohesions cohesions_at(const nlohmann::json& fit, double liquid_content) {
    Cohesions result;
    for (const auto& line : fit.at("cohesion_lines")) {
        if (std::abs(line.at("liquid_content").get<double>() - liquid_content) > 1e-6) continue;
        const auto& cohesion = line.at("cohesion");
        (line.at("source") == "measured" ? result.readings : result.model) = cohesion.at("value");
        result.variance += std::pow(cohesion.at("stderr").get<double>(), 2);
    }
    return result;
}

TEST(WaterGlass, HasOneCohesionForEachContentAndADirectMeasurementSettlesTheFault) {
    const TemporaryFolder folder;
    const fs::path study = copied_example("water-glass", folder);
    const std::string path = study.string();
    json_of("calibrate " + path + " --no-confirm");
    const auto open = json_of("diagnose " + path);
    EXPECT_EQ(open.at("verdict"), "indistinguishable");
    EXPECT_THAT(open.at("effects"), Contains("torque-offset"));

    std::ofstream(study / "study.toml", std::ios::app)
        << "\n[[direct]]\neffect = \"torque-offset\"\nvalue = \"0.98 mN m\"\n"
           "error = \"0.05 mN m\"\n";
    const auto settled = json_of("diagnose " + path);
    EXPECT_EQ(settled.at("verdict"), "missing");
    EXPECT_THAT(settled.at("effects"), ElementsAre("torque-offset"));

    json_of("add " + path + " torque-offset");
    const auto fit = json_of("calibrate " + path + " --no-confirm");
    const auto& parameters = fit.at("parameters");
    for (const auto& [name, truth] : {std::pair{"friction", 0.3}, {"torque-offset.torque", 1e-3}}) {
        const auto& fitted = parameters.at(name);
        EXPECT_NEAR(fitted.at("value"), truth, 3 * fitted.at("stderr").get<double>()) << name;
    }
    // A curve for each normal stress: at two speeds, one curve along the inertial number would show
    // bends that come from the torque offset.
    json_of("compare " + path);
    const std::string drawn = content_of(study / "out/figures/inertial_number.csv");
    for (const char* const stress : {"600 Pa", "1500 Pa", "5000 Pa"}) {
        EXPECT_THAT(drawn, testing::HasSubstr(stress));
    }
    for (const double content : {0.01, 0.03}) {
        const Cohesions cohesions = cohesions_at(fit, content);
        EXPECT_GT(cohesions.readings, 100) << content;
        EXPECT_NEAR(cohesions.readings, cohesions.model, 3 * std::sqrt(cohesions.variance))
            << content;
    }
}

}  // namespace water_glass_test
