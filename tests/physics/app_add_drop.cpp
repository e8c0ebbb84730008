// `pendular add` and `drop` from end to end, on readings that the emulator itself predicts with a
// drag torque, so that the answer is known.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tests/support/app_support.h"
#include "tests/support/effect_study.h"

namespace app_add_drop_test {

using namespace pendular;
using testing::HasSubstr;
namespace fs = std::filesystem;

constexpr double drag = 1e-3;  // N m

/// Dry and wet readings of the laboratory with the drag, scattered as their errors say.
std::string readings() {
    const ModelOfReadings model = laboratory().with({&built_in_effect("torque-offset")});
    const Eigen::VectorXd values =
        model.predict(Eigen::Vector2d(planted_friction, drag), PredictionPart::slopes).value;
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    std::string csv =
        "normal_stress [Pa],shear_stress [Pa],shear_stress_sd [Pa],solid_fraction,"
        "solid_fraction_sd,inertial_number,liquid_content,height [m]\n";
    const auto all = conditions();
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto row = 2 * static_cast<Eigen::Index>(k);
        const double stress = values(row), fraction = values(row + 1);
        csv += fmt::format("{},{:.8g},{:.8g},{:.8g},{:.8g},{},{},{}\n", all[k].normal_stress,
                           stress * (1 + 0.01 * normal(random)), 0.01 * stress,
                           fraction * (1 + 0.002 * normal(random)), 0.002 * fraction,
                           all[k].inertial_number, all[k].liquid_content, *all[k].height);
    }
    return csv;
}

constexpr const char* study_toml = R"(# A study with a drag in its bearings.
[grains]
diameter = "500 um"
density = "1050 kg/m^3"
[liquid]
surface_tension = "20.6 mN/m"
contact_angle = "0 deg"
[cell]
inner_radius = "21 mm"
outer_radius = "45 mm"
bead_mass = "60 g"
[[readings]]
file = "points.csv"
[model]
effects = []   # what the model takes in
)";

TEST(AddAndDrop, FindAPlantedDragAndLeaveTheStudyAsItWas) {
    TemporaryFolder folder;
    folder.write("points.csv", readings());
    const std::string study = folder.write("study.toml", study_toml).string();
    const std::string json = (folder.path() / "change.json").string();
    const Outcome added =
        run_pendular("add " + study + " torque-offset --fidelity quick --quiet --json " + json);
    ASSERT_EQ(added.code, 0) << added.errors;
    expect_told({added.output});
    EXPECT_THAT(content_of(study), HasSubstr("effects = [\"torque-offset\"]   # what"));

    const auto change = nlohmann::json::parse(content_of(json));
    const auto &before = change.at("before"), &after = change.at("after");
    const auto& torque = after.at("parameters").at("torque-offset.torque");
    EXPECT_LT(std::abs(torque.at("value").get<double>() - drag),
              4 * torque.at("stderr").get<double>());
    EXPECT_LT(torque.at("stderr").get<double>(), drag / 5);
    // 60 values: chi2 above 100 has a probability of 1e-3. Without the drag the readings at 0.3 kPa
    // are 10 % off, ten of their errors.
    EXPECT_LT(after.at("chi2").get<double>(), 100);
    EXPECT_GT(before.at("chi2").get<double>(), 3 * after.at("chi2").get<double>());
    for (const char* error : {"rms_percent", "left_out_percent"}) {
        EXPECT_LT(after.at(error).at("shear_stress"), before.at(error).at("shear_stress")) << error;
    }

    const Outcome compared = run_pendular("compare " + study + " --quiet");
    EXPECT_EQ(compared.code, 0) << compared.errors;
    EXPECT_THAT(compared.output, HasSubstr("torque-offset"));

    const Outcome dropped = run_pendular("drop " + study + " torque-offset --quiet");
    ASSERT_EQ(dropped.code, 0) << dropped.errors;
    EXPECT_EQ(content_of(study), study_toml);
    const auto ladder = nlohmann::json::parse(content_of(folder.path() / "out/ladder.json"));
    EXPECT_EQ(ladder.at("ladder_steps").size(), 3u);
    EXPECT_TRUE(fs::exists(folder.path() / "out/figures/ladder.png"));
}

TEST(AddAndDrop, AWrittenEffectTakesPartInTheFit) {
    TemporaryFolder folder;
    folder.write("points.csv", readings());
    const std::string study = folder
                                  .write("study.toml", std::string(study_toml) + R"(
[[effect]]
name = "my-drag"
parameter = "drag"
unit = "mN m"
lower = -10
upper = 10
matters = 0.1
torque = "torque + drag"
)")
                                  .string();
    const std::string json = (folder.path() / "change.json").string();
    const Outcome added =
        run_pendular("add " + study + " my-drag --fidelity quick --quiet --json " + json);
    ASSERT_EQ(added.code, 0) << added.errors;
    const auto change = nlohmann::json::parse(content_of(json));
    const auto& found = change.at("after").at("parameters").at("my-drag.drag");
    EXPECT_LT(std::abs(found.at("value").get<double>() - drag),
              4 * found.at("stderr").get<double>());
}

}  // namespace app_add_drop_test
