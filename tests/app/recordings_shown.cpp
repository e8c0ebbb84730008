// What the recordings themselves show, in the output of `import` and `diagnose`.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "sim/lab/virtual_recording.h"
#include "tests/support/app_support.h"

namespace app_recordings_shown_test {

using namespace pendular;
using testing::HasSubstr;
using testing::Not;

/// Study of eight dry recordings whose states are close to those of polystyrene beads with friction
/// 0.15; torques of the last four are `change` times larger, and cut off at `limit` [N m].
std::filesystem::path write_study(const TemporaryFolder& folder, double change,
                                  double limit = 1000) {
    const GrainProperties grains{.diameter = 5e-4, .density = 1050, .poisson_ratio = 0.3};
    const AnnularCell cell{
        .inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 0.06 / 1050};
    std::vector<TrueState> states;
    for (const double stress : {300.0, 1000.0, 3000.0}) {
        states.push_back({{.normal_stress = stress, .inertial_number = 0.01},
                          {0.2822, 0.001, 1},
                          {0.6137, 0.0003, 1}});
        states.push_back({{.normal_stress = stress, .inertial_number = 0.03},
                          {0.3065, 0.001, 1},
                          {0.6088, 0.0003, 1}});
    }
    for (std::uint64_t file = 0; file < 8; ++file) {
        Recording recording = record(states, cell, grains, {}, 10 * file + 3);
        for (double& torque : recording.torque)
            torque = std::min(limit, torque * (file >= 4 ? change : 1));
        folder.write(fmt::format("dry_{}.csv", file + 1), recording_csv(recording));
    }
    folder.write("study.toml", grains_table + "poisson_ratio = 0.3\n" + cell_table() +
                                   "[[recording]]\nfile = \"dry_*.csv\"\n");
    return folder.path();
}

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

TEST(RecordingsShown, ByImportAreOneLineForEachKind) {
    const TemporaryFolder folder;
    const auto study = write_study(folder, 1.1);
    const std::string text = run_pendular("import " + study.string()).output;
    expect_told({text});
}

TEST(RecordingsShown, ByDiagnoseStandFirstWhereTheyExplainTheMisfit) {
    const TemporaryFolder changed, ordinary;
    const auto text = [](const std::filesystem::path& study) {
        return run_pendular("diagnose --quiet " + study.string()).output;
    };
    expect_told({first_line(text(write_study(changed, 1.15)))});
    EXPECT_THAT(text(write_study(ordinary, 1)), Not(HasSubstr("recordings themselves")));
}

TEST(RecordingsShown, ByDiagnoseAreInItsJson) {
    const TemporaryFolder folder;
    // Torques at 3 kPa are about 150 mN m.
    const auto study = write_study(folder, 1, 0.12);
    const std::string text = run_pendular("diagnose --quiet " + study.string()).output;
    expect_told({text});
    const auto json =
        nlohmann::json::parse(std::ifstream(study / "out" / "diagnosis.json"))["recordings"];
    ASSERT_FALSE(json.empty());
    EXPECT_EQ(json[0]["kind"], "saturation");
    EXPECT_EQ(json[0]["quantity"], "torque");
    EXPECT_TRUE(json[0]["corrected"]);
}

}  // namespace app_recordings_shown_test
