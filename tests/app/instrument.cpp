// A study of examples/wet, whose friction is 0.12, recorded with an instrument that is not exact:
// [instrument] makes the error of the friction hold the truth.
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "tests/support/app_support.h"

namespace app_instrument_test {

namespace fs = std::filesystem;
using nlohmann::json;
using pendular::TemporaryFolder;

constexpr double truth = 0.12;

/// Writes the recordings of examples/wet with factors on torque and force and an addition to the
/// torque [mN m], and returns the path of the study.
std::string spoiled(const TemporaryFolder& folder, double torque, double force, double baseline,
                    const std::string& instrument) {
    const fs::path from = fs::path(PENDULAR_SOURCE_DIR) / "examples/wet";
    const fs::path to = folder.path() / "study";
    fs::create_directory(to);
    for (const auto& entry : fs::directory_iterator(from)) {
        if (entry.path().extension() != ".csv") continue;
        std::ifstream in(entry.path());
        std::ofstream out(to / entry.path().filename());
        std::string line;
        std::getline(in, line);
        EXPECT_EQ(line.rfind("Time [s],Torque [mN m],Normal force [N],Gap [mm]", 0), 0u);
        out << line << "\n";
        while (std::getline(in, line)) {
            std::istringstream cells(line);
            std::string time, torque_cell, force_cell, rest;
            std::getline(cells, time, ',');
            std::getline(cells, torque_cell, ',');
            std::getline(cells, force_cell, ',');
            std::getline(cells, rest);
            out << time << ',' << torque * std::stod(torque_cell) + baseline << ','
                << force * std::stod(force_cell) << ',' << rest << "\n";
        }
    }
    std::ifstream settings(from / "study.toml");
    std::ofstream(to / "study.toml") << settings.rdbuf() << instrument;
    return to.string();
}

json fitted(const std::string& study) {
    return json_of("calibrate " + study + " --no-confirm");
}

double off_in_errors(const json& fit) {
    const json& friction = fit.at("parameters").at("friction");
    return std::abs(friction.at("value").get<double>() - truth) /
           friction.at("stderr").get<double>();
}

double off_with_systematic(const json& fit) {
    const json& friction = fit.at("parameters").at("friction");
    return std::abs(friction.at("value").get<double>() - truth) /
           std::hypot(friction.at("stderr").get<double>(),
                      friction.at("stderr_typical_instrument").get<double>());
}

const std::string typical = "\n[instrument]\nclass = \"rheometer\"\n";

TEST(Instrument, OfAClassHoldsWhatIsOffByAFewPerCent) {
    struct Fault {
        double torque, force, baseline;
    };
    for (const auto& [torque, force, baseline] :
         {Fault{1.03, 1, 0}, Fault{1, 0.97, 0}, Fault{1, 1, 0.5}}) {
        const TemporaryFolder with, without;
        const json fit = fitted(spoiled(with, torque, force, baseline, typical));
        EXPECT_LT(off_in_errors(fit), 2);
        EXPECT_GT(fit.at("parameters").at("friction").at("stderr_instrument"), 0.005);
        const json unstated = fitted(spoiled(without, torque, force, baseline, ""));
        EXPECT_GT(off_in_errors(unstated), 2);
        // The first line states the systematic error beside the other one.
        EXPECT_LT(off_with_systematic(unstated), 1.5);
        EXPECT_EQ(fit.at("parameters").at("friction").at("stderr_typical_instrument"), 0);
    }
}

TEST(Instrument, ThatIsKnownTakesLittle) {
    const TemporaryFolder folder;
    const json fit = fitted(spoiled(folder, 1, 1, 0,
                                    "\n[instrument]\ntorque-gain = \"0.1 %\"\n"
                                    "inner_radius = \"5 um\"\n"));
    EXPECT_LT(off_in_errors(fit), 2);
    EXPECT_LT(fit.at("parameters").at("friction").at("stderr"), 0.003);
    EXPECT_EQ(fit.at("instrument").front().at("name"), "inner_radius");
    EXPECT_TRUE(fit.at("instrument").front().at("counts"));
    EXPECT_FALSE(fit.at("instrument").back().at("counts"));
}

TEST(Instrument, ChangedAfterAFitNeedsAnotherFit) {
    const TemporaryFolder folder;
    const std::string study = spoiled(folder, 1, 1, 0, "");
    fitted(study);
    EXPECT_EQ(run_pendular("compare " + study + " --quiet").code, 0);
    std::ofstream(fs::path(study) / "study.toml", std::ios::app) << typical;
    const Outcome compared = run_pendular("compare " + study + " --quiet");
    EXPECT_EQ(compared.code, 2);
    EXPECT_NE(compared.errors.find("[instrument] of the study have changed"), std::string::npos)
        << compared.errors;
}

}  // namespace app_instrument_test
