// Tables as LabVIEW, Origin, R, gnuplot and people write them, with lines below, comments and
// texts that the rows do not need.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "data/files/formats/layouts.h"
#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_odd_tables_test {

using testing::ElementsAre;
using testing::SizeIs;

constexpr int rows = 24;

/// Rows of time [s], torque [mN m], normal force [N], gap [mm] and angular velocity [rad/s].
/// @param end of each row
std::string table(const std::string& delimiter, const std::string& end = "", int from = 0,
                  int to = rows) {
    std::string text;
    for (int i = from; i < to; ++i)
        text += fmt::format("{1}.5{0}2{2}.25{0}5.0{3}{0}6.2{0}0.5{4}\n", delimiter, i, i % 5, i % 3,
                            end);
    return text;
}

class OddTable : public testing::Test {
  protected:
    /// Expects that a text is read as the rows above.
    /// @param count of the rows
    void expect_rows(const std::string& text, std::size_t count = rows) {
        const auto file = folder_.write(fmt::format("t{}.txt", ++files_), text);
        const Recording recording = read_recording(file);
        ASSERT_EQ(recording.size(), count) << text.substr(0, 200);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_NEAR(recording.time[i] - recording.time[0], static_cast<double>(i), 1e-9);
            EXPECT_NEAR(recording.torque[i], 1e-3 * (20.25 + static_cast<double>(i % 5)), 1e-12);
            EXPECT_NEAR(recording.normal_force[i], 5 + 0.01 * static_cast<double>(i % 3), 1e-12);
            EXPECT_NEAR(recording.height[i], 6.2e-3, 1e-12);
        }
        EXPECT_NEAR(recording.angular_velocity[0], 0.5, 1e-9);
    }
    TemporaryFolder folder_;
    int files_ = 0;
};

const std::string names =
    "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity "
    "[rad/s]";

/// "1.1, 1.2" count the points of a step.
TEST_F(OddTable, MayCountItsPointsWithinSteps) {
    std::string text = "Step;Time [s];Torque [mNm];Normal force [N];Gap [mm];Speed [rpm]\n";
    for (int i = 1; i <= 40; ++i)
        text += fmt::format("1.{};{};28.9;5;7.9;2\n", i, i);
    const auto file = folder_.write("steps.csv", text);
    EXPECT_EQ(read_recording(file).size(), 40u);
    EXPECT_TRUE(read_recording(file).interval.empty() || read_recording(file).interval.back() == 1);
}

TEST_F(OddTable, OfLabViewMayNameACommentThatNoRowHas) {
    const std::string header =
        "LabVIEW Measurement\t\nSeparator\tTab\n***End_of_Header***\t\nChannels\t4\n"
        "***End_of_Header***\nTime [s]\tTorque [mN m]\tNormal force [N]\tGap [mm]\tAngular "
        "velocity [rad/s]\tComment\n";
    expect_rows(header + table("\t"));
    expect_rows(header + table("\t", "\t"));
}

TEST_F(OddTable, OfOriginHasCommentsBelowTheUnits) {
    const std::string origin =
        "Time\tTorque\tNormal force\tGap\tAngular velocity\ns\tmN·m\tN\tmm\trad/s\n";
    expect_rows(origin + "\tcup 2\tcell 1\t\tset 0.5\n" + table("\t"));
    expect_rows("A(X)\tB(Y)\tC(Y)\tD(Y)\tG(Y)\n" + origin + "\t4 kPa\t4 kPa\t4 kPa\t4 kPa\n" +
                table("\t"));
}

TEST_F(OddTable, MayHaveLinesBelowItsRows) {
    for (const std::string below :
         {"Mean,22,5,6.2,0.5\nStd,1,0,0,0\n", "\n\"Mittelwert\",22,5,6.2,0.5\n",
          "*** END OF DATA ***\n", "\nMeasured by: M. M.\nApproved,,,,\n", "-- end --\n"}) {
        expect_rows(names + "\n" + table(",") + below);
        const BlockFile file =
            read_blocks(folder_.write("below.csv", names + "\n" + table(",") + below));
        ASSERT_FALSE(file.skipped.empty());
        EXPECT_EQ(file.skipped[0].kind, Remark::Kind::after_interval);
    }
    // A digit that is no number is a mistake to be told.
    expect_told({input_error([&] {
        read_recording(folder_.write("t.csv", names + "\n" + table(",") + "2O.5,22,5,6.2,0.5\n"));
    })});
}

TEST_F(OddTable, MayHaveTitlesAndMeansAmongItsRows) {
    for (const std::string& end : {std::string(), std::string(",,,,")}) {
        std::string titles = names + "\n", means = titles;
        for (int step = 0; step < 3; ++step) {
            titles += fmt::format("Step {}: 4 kPa{}\n", step, end) +
                      table(",", "", 8 * step, 8 * step + 8);
            means += table(",", "", 8 * step, 8 * step + 8) + "Mean,22,5,6.2,0.5\n\n";
        }
        expect_rows(titles);
        expect_rows(means);
        const Recording recording = read_recording(folder_.write("titles.csv", titles));
        EXPECT_THAT(recording.left_out, SizeIs(3));
    }
    // The rows of another table are no rows of this one.
    EXPECT_THROW(
        read_recording(folder_.write("two.csv", names + "\n" + table(",") +
                                                    "\nSummary,,,,\nLoad [kPa],Mean "
                                                    "torque [mN m],,,\n4,20,,,\n8,40,,,\n")),
        InputError);
    // A column of remarks has words where the others have none.
    std::string remarks = "Remark," + names + "\n";
    for (int i = 0; i < rows; ++i)
        remarks += (i % 7 == 6 ? "zero," : ",") + table(",", "", i, i + 1);
    expect_rows(remarks);
}

TEST_F(OddTable, OfRNumbersItsRowsWithoutAName) {
    std::string text = "\"time_s\" \"torque_mNm\" \"normal_force_N\" \"gap_mm\" \"omega_rad_s\"\n";
    for (int i = 0; i < rows; ++i)
        text += fmt::format("\"{}\" {}", i + 1, table(" ", "", i, i + 1));
    expect_rows(text);
}

TEST_F(OddTable, MayBeAlignedByTabs) {
    expect_rows(
        "Time [s]\t\tTorque [mN m]\t\tNormal force [N]\tGap [mm]\tAngular velocity "
        "[rad/s]\n" +
        table("\t\t"));
}

TEST_F(OddTable, OfGnuplotHasATitleInACommentBelowTheNames) {
    expect_rows("# time[s] torque[mN.m] normal_force[N] gap[mm] omega[rad/s]\n# 4 kPa\n" +
                table(" ", "", 0, 12) + "\n\n# 8 kPa\n" + table(" ", "", 12, rows));
}

TEST_F(OddTable, MayStateTheFormOfItsClock) {
    std::string text =
        "Zeit [min:s];Drehmoment [mNm];Normalkraft [N];Spalt [mm];"
        "Drehgeschwindigkeit [1/min]\n";
    for (int i = 0; i < rows; ++i)
        text +=
            fmt::format("{}:{:02},5;2{},25;5,0{};6,2;4,774648293\n", i / 60, i % 60, i % 5, i % 3);
    expect_rows(text);
}

TEST_F(OddTable, MayHaveTheMissingValuesOfOtherLoggers) {
    for (const std::string mark : {"-999.25", "-9999.25", "-99999", "ERR", "missing"}) {
        const Recording recording = read_recording(folder_.write(
            "t.csv", names + "\n" + table(",") + fmt::format("30.5,{},5.0,6.2,0.5\n", mark)));
        EXPECT_EQ(recording.size(), static_cast<std::size_t>(rows)) << mark;
        EXPECT_THAT(recording.left_out, SizeIs(1)) << mark;
    }
}

TEST_F(OddTable, IsRefusedByWhatItIs) {
    expect_told({input_error([&] {
                     read_blocks(folder_.write("lying.csv",
                                               "Time [s],0,1,2,3\nTorque [mN m],20,21,20,21\n"
                                               "Gap [mm],6,6,6,6\n"));
                 }),
                 input_error([&] {
                     read_blocks(
                         folder_.write("t.tex", "\\begin{tabular}{ll}\nTime & Torque \\\\\n"));
                 })});
}

/// Signs around a table that are no part of it: no-break spaces, the end of a text of DOS, zeros of
/// a file that was not closed, a unit whose bytes were read twice in the wrong encoding.
TEST_F(OddTable, MayHaveSignsAroundItsCells) {
    const std::string text = names + "\n" + table(",");
    std::string spaced = text;
    for (std::size_t at = spaced.find(','); at != std::string::npos; at = spaced.find(',', at + 3))
        spaced.replace(at, 1, ",\u00a0");
    expect_rows(spaced);
    expect_rows(text + "\x1a");
    expect_rows(text + std::string(512, '\0'));
    std::string twice = text;
    twice.replace(twice.find("mN m"), 4, "\u00c2\u00b5N km");
    const Recording recording = read_recording(folder_.write("twice.csv", twice));
    EXPECT_NEAR(recording.torque[0], 0.02025, 1e-12);
    std::string seconds = text;
    seconds.replace(seconds.find("[s]"), 3, "[Sek.]");
    expect_rows(seconds);
}

/// "0.5 s" in the first row is a value, not a unit.
TEST_F(OddTable, OfValuesWithUnitsIsRefused) {
    expect_told({input_error([&] {
        read_recording(folder_.write("t.csv",
                                     "Time,Torque,Normal force,Gap,Angular velocity\n"
                                     "0.5 s,20.1 mNm,5.0 N,6.2 mm,0.5 rad/s\n"
                                     "1.0 s,20.1 mNm,5.0 N,6.2 mm,0.5 rad/s\n"));
    })});
}

FileView points(const TemporaryFolder& folder, const std::string& text) {
    return view_of_file(folder.write("points.csv", text));
}

TEST(PointsWithTexts, MayBePreshearsByTheirNames) {
    const TemporaryFolder folder;
    const FileView view =
        points(folder,
               "Step,Normal Stress (kPa),Shear Stress (kPa)\nPreshear 1,9,4.5\nShear 1,7,4.1\n"
               "Preshear 2,9,4.7\nShear 2,6,3.7\nPreshear 3,9,4.6\nShear 3,5,3.2\n"
               "Preshear 4,9,4.6\nShear 4,4,2.75\n");
    ASSERT_THAT(view.loci, SizeIs(1));
    ASSERT_THAT(view.loci[0].points, SizeIs(4));
    EXPECT_DOUBLE_EQ(view.loci[0].points[1].shear_stress, 3700);
    ASSERT_TRUE(view.loci[0].preshear);
    EXPECT_DOUBLE_EQ(view.loci[0].preshear->normal_stress, 9000);
}

/// Points of two materials in one table are no one line.
TEST(PointsWithTexts, MakeALocusForEachMaterial) {
    const TemporaryFolder folder;
    const FileView walls =
        points(folder,
               "Wall material,Wall normal stress [Pa],Wall shear stress [Pa]\nsteel,500,180\n"
               "PTFE,500,100\nsteel,1000,360\nPTFE,1000,200\nsteel,2000,720\nPTFE,2000,400\n");
    ASSERT_THAT(walls.walls, SizeIs(2));
    EXPECT_EQ(walls.walls[0].test, "steel");
    EXPECT_NEAR(walls.walls[0].coefficient, 0.36, 1e-12);
    EXPECT_NEAR(walls.walls[1].coefficient, 0.2, 1e-12);
    const FileView loci =
        points(folder,
               "Sample,Normal stress [Pa],Shear stress [Pa]\na,500,400\na,1000,700\n"
               "a,2000,1300\nb,500,300\nb,1000,550\nb,2000,1050\n");
    ASSERT_THAT(loci.loci, SizeIs(2));
    EXPECT_NEAR(loci.loci[0].line->cohesion, 100, 1e-9);
    EXPECT_NEAR(loci.loci[1].line->cohesion, 50, 1e-9);
    // Remarks on single points tell no materials apart.
    const FileView remarks = points(folder,
                                    "Sample,Normal stress [Pa],Shear stress [Pa]\nfirst,500,400\n"
                                    "second,1000,700\nthird,2000,1300\n");
    EXPECT_THAT(remarks.loci, SizeIs(1));
}

/// Numbers of samples, and texts of three rows in succession, tell tests apart; numbers of points
/// and densities do not.
TEST(PointsWithTexts, MayNumberTheirTests) {
    const TemporaryFolder folder;
    for (const auto& [first, second] : {std::pair("1", "2"), std::pair("3 kPa", "6 kPa")}) {
        std::string text = std::string("Test") + ";Normalspannung [kPa];Schubspannung [kPa]\n";
        for (const int k : {1, 2, 3})
            text += fmt::format("{};{},0;0,{}5\n", first, k, 2 + 2 * k);
        for (const int k : {1, 2, 3})
            text += fmt::format("{};{},0;1,{}5\n", second, k, 2 + 2 * k);
        EXPECT_THAT(points(folder, text).loci, SizeIs(2)) << first;
    }
    const FileView numbered =
        points(folder,
               "Test no.,Normal stress [Pa],Shear stress [Pa],Bulk density [kg/m^3]\n"
               "1,500,400,1480\n2,1000,700,1481\n3,2000,1300,1480\n4,3000,1900,1482\n");
    ASSERT_THAT(numbered.loci, SizeIs(1));
    EXPECT_THAT(numbered.loci[0].points, SizeIs(4));
}

}  // namespace pendular::data_odd_tables_test
