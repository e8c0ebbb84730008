// What headers state about the cell, and measured values beside their set points.
#include <fmt/format.h>

#include "data/files/formats/layouts.h"
#include "data/recordings/checks.h"
#include "data/recordings/file_view.h"
#include "data/recordings/measurements.h"
#include "data/recordings/stated_cell.h"
#include "data/study/study.h"
#include "tests/support/golden.h"

namespace pendular::data_file_findings_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// A recording of two stretches of 100 rows, 5 N and 2 N, with set points; the measured force is
/// `follow` times the set point of the second stretch.
std::string recording(const std::string& comments, double follow) {
    std::string text = comments +
                       "Time [s],Torque [mN m],Normal force [N],Normal force set [mN],Gap [mm],"
                       "Angular velocity [rad/s],Interval [1]\n";
    for (int i = 0; i < 200; ++i) {
        const double set = i < 100 ? 5 : 2;
        const double force = (i < 100 ? set : follow * set) + (i % 3 - 1) * 1e-3;
        text += fmt::format("{:.1f},{:.3f},{:.4f},{:.0f},{:.4f},0.1,{}\n", 0.1 * i,
                            6 * force + 0.01 * (i % 5), force, 1000 * set, 4 + 0.001 * (i % 7),
                            i < 100 ? 1 : 2);
    }
    return text;
}

class FileFindings : public testing::Test {
  protected:
    BlockFile read(const std::string& text) { return read_blocks(folder_.write("t.csv", text)); }
    TemporaryFolder folder_;
};

TEST_F(FileFindings, ReadRadiiAndConstantsOfHeaders) {
    const BlockFile file =
        read(recording("# Inner diameter [mm]: 42\n# Outer radius = 4.5 cm\n# Ri: x\n", 1));
    const StatedCell cell = stated_cell(file);
    ASSERT_TRUE(cell.inner_radius && cell.outer_radius);
    EXPECT_NEAR(cell.inner_radius->value, 0.021, 1e-12);
    EXPECT_NEAR(cell.outer_radius->value, 0.045, 1e-12);
    EXPECT_EQ(cell.outer_radius->line, 2);
    const StatedCell trios =
        stated_cell(read_blocks(PENDULAR_SOURCE_DIR "/tests/data/formats/trios.csv"));
    ASSERT_TRUE(trios.stress_per_torque && trios.stress_per_force);
    EXPECT_NEAR(trios.stress_per_torque->value, 79577.5, 1e-6);
    EXPECT_NEAR(trios.stress_per_force->value, 1591.55, 1e-6);
    EXPECT_EQ(trios.stress_per_torque->line, 6);
}

TEST_F(FileFindings, CompareHeadersWithTheStudyToOnePerCent) {
    const BlockFile file = read(recording("# Inner radius: 21 mm\n# Outer radius: 45.3 mm\n", 1));
    AnnularCell cell{.inner_radius = 0.021, .outer_radius = 0.045};
    EXPECT_THAT(header_against_study(file, cell), IsEmpty());  // 0.7 % apart
    cell.outer_radius = 0.0445;
    const std::vector<Remark> findings = header_against_study(file, cell);
    ASSERT_THAT(findings, SizeIs(1));
    EXPECT_THAT(findings[0].lines, ElementsAre(Lines{2, 2}));
    expect_told({text_of(findings[0])});
    EXPECT_EQ(findings[0].file(), file.file);
}

TEST_F(FileFindings, NameSetPointsThatAreNotFollowed) {
    EXPECT_THAT(missed_set_points(read(recording("", 1.015))), IsEmpty());
    const std::vector<Remark> findings = missed_set_points(read(recording("", 0.9)));
    ASSERT_THAT(findings, SizeIs(1));
    EXPECT_THAT(findings[0].lines, ElementsAre(Lines{102, 201}));
    expect_told({text_of(findings[0])});
}

TEST_F(FileFindings, FindSetPointsOfSpeedInTablesWithRowsOfUnits) {
    std::string text =
        "Point No.,Time,Speed,Speed (target),Gap,Gap set\n,[s],[1/min],[1/min],[mm],[mm]\n";
    for (int i = 1; i <= 40; ++i)
        text += fmt::format("{},{},{:.3f},0.5,2.0,2.0\n", i, i, 0.47 + 0.001 * (i % 3));
    const FileView view = view_of_file(folder_.write("t.csv", text));
    ASSERT_THAT(view.findings, SizeIs(1));
    EXPECT_EQ(to_string(view.findings[0]), "set-point");
    expect_told({text_of(view.findings[0])});
}

TEST_F(FileFindings, AreMadeByTheImportOfAStudy) {
    folder_.write("study.toml",
                  grains_table + cell_table("10 g") + "[[recording]]\nfile = \"run.csv\"\n");
    const auto file = folder_.write("run.csv", recording("# Inner radius: 20 mm\n", 0.9));
    const Study study = read_study(folder_.path());
    const Measurements measurements = read_measurements(study);
    ASSERT_THAT(measurements.faults(false), SizeIs(2));
    EXPECT_EQ(to_string(measurements.faults(false)[0]), "header-cell");
    EXPECT_EQ(measurements.faults(false)[0].file(), file.string());
    EXPECT_EQ(to_string(measurements.faults(false)[1]), "set-point");
    EXPECT_THAT(view_of_file(file, {}, study.cell).findings, SizeIs(2));
    EXPECT_THAT(view_of_file(file).findings, SizeIs(1));
}

}  // namespace pendular::data_file_findings_test
