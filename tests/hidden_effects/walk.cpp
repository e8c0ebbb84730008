// The whole way by command line, on recordings of virtual laboratories whose truth stands in
// truths/ and is read last: calibrate, compare, diagnose, add what it names, and see the error fall
// until nothing more is found missing. Truths are simulated, with seeds and conditions
// other than those of the atlas, of as many beads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/support/app_support.h"

namespace walk_test {

using namespace pendular;
namespace fs = std::filesystem;

const fs::path here = fs::path(PENDULAR_SOURCE_DIR) / "tests/hidden_effects";

nlohmann::json told(const std::string& command, const std::vector<int>& codes = {0}) {
    const Outcome outcome = run_pendular(command + " --quiet --json -");
    EXPECT_THAT(codes, testing::Contains(outcome.code)) << command << outcome.errors;
    return nlohmann::json::parse(outcome.output, nullptr, false);
}

/// Name and value of the hidden effect, "" where there is none.
struct Truth {
    std::string effect, parameter;
    double value = 0, friction = 0;
};

Truth truth_of(const std::string& study) {
    std::ifstream file(here / "truths" / (study + ".json"));
    const auto json = nlohmann::json::parse(file);
    Truth truth{.friction = json.at("friction")};
    for (const auto& [name, value] : json.at("effects").items()) {
        truth.effect = name.substr(0, name.find('.'));
        truth.parameter = name;
        truth.value = value;
    }
    return truth;
}

bool nothing_missing(const nlohmann::json& diagnosis) {
    return diagnosis.at("verdict") == "nothing-missing" ||
           diagnosis.at("verdict") == "inconclusive";
}

double left_out(const nlohmann::json& ladder_step) {
    return ladder_step.at("left_out_percent").at("shear_stress");
}

class HiddenEffects : public testing::TestWithParam<const char*> {};

TEST_P(HiddenEffects, AreFoundByTheWholeWalk) {
    const TemporaryFolder folder;
    const std::string path = (folder.path() / "study").string();
    fs::copy(here / GetParam(), path, fs::copy_options::recursive);

    const Truth truth = truth_of(GetParam());
    // What is hidden may drive the friction to the end of its range: a meaningless fit, code 3.
    const std::vector<int> codes = truth.effect.empty() ? std::vector{0} : std::vector{0, 3};
    const auto fit = told("calibrate " + path + " --no-confirm", codes);
    const auto compared = told("compare " + path);
    const auto diagnosis = told("diagnose " + path);
    if (truth.effect.empty()) {
        EXPECT_TRUE(nothing_missing(diagnosis)) << diagnosis.at("sentence");
        const auto friction = fit.at("parameters").at("friction");
        EXPECT_NEAR(friction.at("value"), truth.friction, 3 * friction.at("stderr").get<double>());
        return;
    }
    EXPECT_LT(compared.at("where").at("p"), 0.01);
    EXPECT_EQ(diagnosis.at("verdict"), "missing");
    ASSERT_THAT(diagnosis.at("effects").get<std::vector<std::string>>(),
                testing::ElementsAre(truth.effect));

    const auto added = told("add " + path + " " + truth.effect);
    EXPECT_LT(left_out(added.at("after")), 0.9 * left_out(added.at("before")));
    EXPECT_LT(added.at("after").at("chi2"), 0.5 * added.at("before").at("chi2").get<double>());
    const auto after = told("compare " + path);
    EXPECT_GT(after.at("p"), 0.01);
    EXPECT_TRUE(nothing_missing(told("diagnose " + path)));
    const auto parameters = added.at("after").at("parameters");
    if (parameters.contains(truth.parameter)) {
        const auto& found = parameters.at(truth.parameter);
        EXPECT_NEAR(found.at("value"), truth.value, 4 * found.at("stderr").get<double>());
    }
    const auto& friction = parameters.at("friction");
    EXPECT_NEAR(friction.at("value"), truth.friction, 4 * friction.at("stderr").get<double>());
}

INSTANTIATE_TEST_SUITE_P(Sealed, HiddenEffects,
                         testing::Values("study_1", "study_2", "study_3", "study_4", "study_5"),
                         [](const auto& study) { return std::string(study.param); });

}  // namespace walk_test
