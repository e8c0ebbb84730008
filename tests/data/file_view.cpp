// What a file of measurements shows by itself: findings, roles of intervals, yield loci.
#include "data/recordings/file_view.h"

#include <fmt/format.h>

#include <cmath>

#include "data/files/text_file.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_file_view_test {

using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Files that were cut off or whose bytes were changed are read or refused with a message, and do
/// not end the program.
TEST(FileViewTest, SurvivesDamagedFiles) {
    const TemporaryFolder folder;
    std::mt19937_64 random(1);
    FileFormat stated;
    stated.columns = {"Time [s]", "Torque [N m]"};
    const std::string bytes = "\t;,.\"[]()|:-*0123456789\n\r\xFF";
    for (const auto& entry : std::filesystem::directory_iterator(look_alike(""))) {
        const std::string text = read_text(entry.path());
        for (int trial = 0; trial < 60; ++trial) {
            std::string damaged = text.substr(0, trial < 30 ? random() % text.size() : text.size());
            for (int k = 0; k < trial % 10 && !damaged.empty(); ++k)
                damaged[random() % damaged.size()] = bytes[random() % bytes.size()];
            const auto path = folder.write("t.csv", damaged);
            FileFormat format = trial % 2 ? FileFormat{} : stated;
            if (trial % 5 == 0) format.layout = layout_names()[random() % layout_names().size()];
            try {
                view_of_file(path, format);
                read_recording(path, format);
            } catch (const InputError&) {
            }
        }
    }
}

TEST(FileViewTest, FindsDamagedTorques) {
    FileFormat format;
    format.columns = {"Point No. [1]",     "Time [s]",           "Gap [mm]",
                      "Normal Force [N]",  "Normal Stress [Pa]", "Torque [mN m]",
                      "Shear Stress [Pa]", "Speed [1/min]"};
    const FileView view = view_of_file(look_alike("no_units_damaged_torque.csv"), format);
    // Rows 1 to 20 of interval 1 (lines 2 to 21) and 3 to 8 of interval 2 (lines 30 to 35): more
    // than half of all rows, but the ratio of normal stress to force gives the cup away.
    ASSERT_THAT(view.findings, SizeIs(1));
    EXPECT_THAT(view.findings[0].lines, ElementsAre(Lines{2, 21}, Lines{30, 35}));
    expect_told({text_of(view.findings[0])});
    EXPECT_NEAR(*view.cell.outer_radius, 0.0215, 1e-9);
    EXPECT_THAT(view_of_file(look_alike("unit_row.csv")).findings, IsEmpty());
}

TEST(FileViewTest, ComparesTheConstantsOfAHeaderWithTheColumns) {
    TemporaryFolder folder;
    std::string text = read_text(look_alike("trios.csv"));
    const std::string stated = "79577.5 Pa/N.m";
    text.replace(text.find(stated), stated.size(), "20000 Pa/N.m");
    const FileView view = view_of_file(folder.write("t.csv", text));
    EXPECT_THAT(view.findings,
                Contains(testing::Field(&Remark::kind, Remark::Kind::header_constant)));
    EXPECT_THAT(
        view_of_file(look_alike("trios.csv")).findings,
        testing::Not(Contains(testing::Field(&Remark::kind, Remark::Kind::header_constant))));
}

TEST(FileViewTest, FindsIntervalsThatDeclareAnotherNumberOfPoints) {
    const FileView view = view_of_file(look_alike("rheocompass_fr.txt"));
    std::vector<std::string> kinds;
    for (const Remark& finding : view.findings)
        kinds.push_back(to_string(finding));
    EXPECT_THAT(kinds, ElementsAre("declared-rows", "several-tests"));
    expect_told({text_of(view.findings[0])});
}

TEST(FileViewTest, DividesAPlainTableByItsIntervals) {
    TemporaryFolder folder;
    std::string text = "Interval,Time [s],Normal stress [Pa],Shear stress [Pa]\n";
    for (int i = 0; i < 40; ++i)
        text += std::string(i < 25 ? "3" : "5") + "," + std::to_string(i) + ",1000,300\n";
    const FileView view = view_of_file(folder.write("t.csv", text));
    ASSERT_EQ(view.file.blocks.size(), 2u);
    EXPECT_EQ(view.file.blocks[0].table.rows.size(), 25u);
    EXPECT_EQ(view.file.blocks[1].table.rows.size(), 15u);
    EXPECT_EQ(view.file.blocks[1].number, 5);
}

std::vector<std::string> role_names(const FileView& view) {
    std::vector<std::string> names;
    for (const IntervalRole& role : view.roles)
        names.push_back(role.role);
    return names;
}

TEST(FileViewTest, FindsTheRolesOfAYieldLocusTest) {
    const FileView view = view_of_file(look_alike("powder_cell_all.txt"));
    EXPECT_THAT(role_names(view), ElementsAre("filling", "preshear", "unloading", "failure",
                                              "reloading", "preshear", "unloading", "failure",
                                              "reloading", "preshear", "unloading", "failure"));
    EXPECT_THAT(role_names(view_of_file(look_alike("powder_cell.txt"))),
                ElementsAre("failure", "failure", "failure"));
    FileFormat format;
    format.roles = {{"steady", {"8"}}};
    EXPECT_THAT(role_names(view_of_file(look_alike("powder_cell.txt"), format)),
                ElementsAre("failure", "steady", "failure"));
}

/// Text of a recording at 20 rpm, one interval of 30 rows for each pair of normal force [N] and
/// torque [mN m].
std::string recording_at(const std::vector<std::pair<double, double>>& loads,
                         const std::string& speed = "20") {
    std::string text = "Interval,Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [1/min]\n";
    for (std::size_t i = 0; i < loads.size(); ++i)
        for (int row = 0; row < 30; ++row)
            text += fmt::format("{},{},{},{},6.2,{}\n", i + 1, 30 * i + row,
                                loads[i].second * (1 + 0.01 * (row % 3)), loads[i].first, speed);
    return text;
}

TEST(FileViewTest, CallsAnIntervalShearedIfTheLidTurns) {
    // The first torques are 0.6 and 2 % of the largest: at low normal force, a drag shows there.
    const TemporaryFolder folder;
    const auto path =
        folder.write("t.csv", recording_at({{0.05, 0.2}, {0.2, 0.7}, {2, 7}, {10, 35}}));
    EXPECT_THAT(role_names(view_of_file(path)),
                ElementsAre("steady", "steady", "steady", "steady"));
}

TEST(FileViewTest, CallsAnIntervalWithoutSpeedShearedByItsOwnStressRatio) {
    // The first stress ratio, 0.4, is that of sheared grains, 0.01 of the second interval is not.
    const TemporaryFolder folder;
    std::string text = "Interval,Time [s],Normal stress [Pa],Shear stress [Pa]\n";
    const std::vector<std::pair<double, double>> loads = {{20, 8}, {3000, 30}, {3000, 1000}};
    for (std::size_t i = 0; i < loads.size(); ++i)
        for (int row = 0; row < 30; ++row)
            text += fmt::format("{},{},{},{}\n", i + 1, row, loads[i].first, loads[i].second);
    const auto path = folder.write("t.csv", text);
    EXPECT_THAT(role_names(view_of_file(path)), ElementsAre("steady", "reloading", "steady"));
}

TEST(FileViewTest, CallsARestARestWhateverTorqueIsLeft) {
    const TemporaryFolder folder;
    std::string text = recording_at({{10, 35}, {10, 20}});
    for (std::size_t at = text.find("\n2,"); at != std::string::npos;
         at = text.find("\n2,", at + 1)) {
        const std::size_t end = text.find('\n', at + 1);
        text.replace(end - 2, 2, "0");
    }
    const auto path = folder.write("t.csv", text);
    EXPECT_THAT(role_names(view_of_file(path)), ElementsAre("steady", "reloading"));
}

TEST(FileViewTest, SaysThatASpeedChangesWithinAnInterval) {
    const TemporaryFolder folder;
    std::string text = recording_header;
    for (int row = 0; row < 200; ++row)
        text += fmt::format("{},50,5,6.2,{}\n", row, 0.05 + 0.05 * row);
    const FileView view = view_of_file(folder.write("t.csv", text));
    ASSERT_THAT(view.roles, SizeIs(1));
    EXPECT_EQ(view.roles[0].role, "other");
    expect_told({view.roles[0].reason});
}

TEST(FileViewTest, FindsNormalForcesOfTheWrongSign) {
    const TemporaryFolder folder;
    const FileView view = view_of_file(folder.write("t.csv", recording_at({{-5, 20}, {-10, 40}})));
    ASSERT_THAT(view.findings, SizeIs(1));
    EXPECT_EQ(view.findings[0].kind, Remark::Kind::no_compression);
    expect_told({text_of(view.findings[0])});
    EXPECT_THAT(view_of_file(folder.write("u.csv", recording_at({{-5, 20}, {10, 40}}))).findings,
                IsEmpty());
}

TEST(YieldLocusTest, IsTheLineThroughTheLargestStresses) {
    const FileView view = view_of_file(look_alike("powder_cell_all.txt"));
    ASSERT_THAT(view.loci, SizeIs(1));
    const YieldLocus& locus = view.loci[0];
    // The look-alike fails at 100 Pa + 0.3 of the normal stress.
    ASSERT_TRUE(locus.line);
    EXPECT_NEAR(locus.line->cohesion, 100, 1e-9);
    EXPECT_NEAR(std::tan(locus.line->slope_angle), 0.3, 1e-12);
    EXPECT_NEAR(locus.preshear->normal_stress, 3000, 1e-9);
    EXPECT_NEAR(locus.preshear->shear_stress, 975, 1e-9);  // mean of the last two rows
    EXPECT_FALSE(locus.points[0].at_end);
    // The window of five rows begins at the peak or ends with it.
    EXPECT_LT(locus.points[0].smoothed_shear_stress, locus.points[0].shear_stress);
}

TEST(YieldLocusTest, SaysWhereFailureMayNotHaveBeenReached) {
    TemporaryFolder folder;
    std::string text = "Point No.,Normal Stress,Shear Stress\n,[Pa],[Pa]\n";
    for (int i = 1; i <= 40; ++i)
        text += std::to_string(i) + ",1000," + std::to_string(10 * i) + "\n";
    FileFormat format;
    format.roles = {{"failure", {"1"}}};
    const FileView view = view_of_file(folder.write("t.csv", text), format);
    ASSERT_THAT(view.loci, SizeIs(1));
    EXPECT_TRUE(view.loci[0].points[0].at_end);
    EXPECT_FALSE(view.loci[0].line);  // one point makes no line
}

/// The report of an instrument: preshear 2027/1336 Pa, cohesion 106.5 Pa and slope 43.54 deg give
/// an unconfined strength of 496.4 Pa, a major principal stress of 3193 Pa, a flowability of 6.43
/// and an effective angle of 46.95 deg. Two points on the line stand for its five.
TEST(YieldLocusTest, ConvertsALineToStrengthAndFlowability) {
    const double slope = std::tan(43.54 * M_PI / 180);
    const LinearYieldLocus locus = linear_yield_locus(
        {1000, 1500}, {106.5 + 1000 * slope, 106.5 + 1500 * slope}, PreshearPoint{2027, 1336});
    // The printed cohesion is rounded to 0.05 %.
    EXPECT_NEAR(locus.unconfined_strength, 496.4, 0.25);
    EXPECT_NEAR(locus.tensile_strength, -112.1, 0.05);
    EXPECT_NEAR(*locus.major_principal_stress, 3193, 1);
    EXPECT_NEAR(*locus.flowability, 6.43, 0.01);
    EXPECT_NEAR(*locus.effective_angle * 180 / M_PI, 46.95, 0.01);
    EXPECT_EQ(locus.flow_class, "easy-flowing");
    const LinearYieldLocus negative = linear_yield_locus({1000, 2000}, {900, 2000}, {});
    EXPECT_EQ(negative.cohesion, 0);
    EXPECT_EQ(negative.unconfined_strength, 0);
}

/// The points of failure of that report, whose stresses are printed to four digits: an error of 0.5
/// Pa in one of five points moves the intercept by about 1 Pa and the slope by about 0.03 deg.
/// Source: SauretLab/ShearCell, commit f62e107, 1 mm glass with 0.5 % of water, preshear at 2 kPa.
TEST(YieldLocusTest, IsThatOfAnInstrumentsReport) {
    const LinearYieldLocus locus = linear_yield_locus(
        {790, 1040, 1356, 1491, 1572}, {770, 1346, 928.1, 1962, 1466}, PreshearPoint{2027, 1336});
    EXPECT_NEAR(locus.cohesion, 106.5, 1.5);
    EXPECT_NEAR(locus.slope_angle * 180 / M_PI, 43.54, 0.05);
    EXPECT_NEAR(locus.tensile_strength, -112.1, 4);
    EXPECT_NEAR(locus.unconfined_strength, 496.4, 6);
    EXPECT_NEAR(*locus.major_principal_stress / 3193, 1, 1e-3);
}

}  // namespace pendular::data_file_view_test
