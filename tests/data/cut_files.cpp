// Files that end within their last row, and intervals in which the set points change.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "data/files/formats/layouts.h"
#include "data/recordings/file_view.h"
#include "data/recordings/measurements.h"
#include "data/recordings/recording.h"
#include "data/recordings/steps.h"
#include "tests/support/golden.h"
#include "tests/support/ordinary_studies.h"

namespace pendular::data_cut_files_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Names and units, in one line or in two, and 30 rows with a torque of 40 to 43 mN m at the end.
std::string table(bool unit_row, int rows = 30) {
    std::string text = unit_row ? "Zeit;Normalkraft;Spalt;Winkelgeschwindigkeit;Drehmoment\n"
                                  "s;N;mm;rad/s;mNm\n"
                                : "Time [s];Normal force [N];Gap [mm];Angular velocity [rad/s];"
                                  "Torque [mN m]\n";
    for (int i = 0; i < rows; ++i)
        text += fmt::format("{};5,01;6,20;0,5;4{},{}5\n", i, i % 4, i % 7);
    return text;
}

class CutFile : public testing::TestWithParam<bool> {
  protected:
    BlockFile read(const std::string& text) { return read_blocks(folder_.write("t.csv", text)); }
    TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(EachHeader, CutFile, testing::Bool());

TEST_P(CutFile, LosesTheRowThatEndsIt) {
    const int line = GetParam() ? 33 : 32;
    // Within a cell, within the last number, behind its decimal mark, behind a whole first cell.
    for (const std::string end :
         {"30;5,0", "30;5,01;6,20;0,5;4", "30;5,01;6,20;0,5;41,", "30;5", "30;5,01;6,20;0,5;"}) {
        const BlockFile file = read(table(GetParam()) + end);
        EXPECT_THAT(file.blocks.front().table.rows, SizeIs(30)) << end;
        ASSERT_THAT(file.skipped, SizeIs(1)) << end;
        EXPECT_EQ(file.skipped[0].kind, Remark::Kind::cut_short);
        EXPECT_EQ(file.skipped[0].first_line(), line);
    }
}

TEST_P(CutFile, KeepsAWholeRowWithoutLineEnd) {
    for (const std::string end : {"30;5,01;6,20;0,5;41,25", "30;5,01;6,20;0,5;39,05", ""}) {
        const BlockFile file = read(table(GetParam()) + end);
        EXPECT_THAT(file.skipped, IsEmpty()) << end;
    }
}

TEST(CutFileOfNumbers, KeepsASmallerWholeNumber) {
    const TemporaryFolder folder;
    std::string text = "Time [s],Normal stress [Pa],Shear stress [Pa],Bulk density [kg/m^3]\n";
    for (int i = 1; i <= 12; ++i)
        text += fmt::format("{},{},{},1480\n", i, 500 * i, 300 * i);
    EXPECT_THAT(read_blocks(folder.write("t.csv", text + "13,7000,4100,990")).skipped, IsEmpty());
    EXPECT_THAT(read_blocks(folder.write("t.csv", text + "13,7000,4100,99")).skipped, SizeIs(1));
}

/// A table without time is typed: its last point may be the smallest, its last line have no end.
TEST(CutFileOfNumbers, KeepsTheLastPointOfATypedTable) {
    const TemporaryFolder folder;
    std::string text = "Normal stress [Pa],Shear stress [Pa]\n";
    for (int i = 12; i >= 1; --i)
        text += fmt::format("{},{}\n", 1000 * i, 600 * i + 1000);
    const BlockFile file = read_blocks(folder.write("t.csv", text + "150,95"));
    EXPECT_THAT(file.skipped, IsEmpty());
    EXPECT_THAT(file.blocks.front().table.rows, SizeIs(13));
}

/// A table of few rows is typed by people, each of whose rows counts.
TEST(CutFileOfFewRows, IsRefused) {
    const TemporaryFolder folder;
    const auto file = folder.write("t.csv", table(false, 4) + "5;5");
    expect_told({input_error([&] { read_blocks(file); })});
}

TEST(CutRecording, IsReadAlikeByTheQuickReader) {
    const TemporaryFolder folder;
    const std::string header =
        "Time [s],Normal force [N],Gap [mm],Angular velocity [rad/s],Torque [mN m]\n";
    std::string rows;
    for (int i = 0; i < 30; ++i)
        rows += fmt::format("{},5.01,6.20,0.5,4{}.{}5\n", i, i % 4, i % 7);
    const auto cut = folder.write("cut.csv", header + rows + "30,5.01,6.20,0.5,4");
    EXPECT_FALSE(quick_recording(cut, {}));
    const Recording general = recording_of(read_blocks(cut), {});
    EXPECT_EQ(general.size(), 30u);
    EXPECT_THAT(general.left_out, SizeIs(1));
    const auto whole = folder.write("whole.csv", header + rows + "30,5.01,6.20,0.5,40.05");
    const auto recording = quick_recording(whole, {});
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->size(), 31u);
}

/// Rows at three loads, in one interval.
std::string three_loads(const std::string& interval) {
    std::string text =
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],Interval [1]\n";
    for (int i = 0; i < 180; ++i)
        text += fmt::format("{},{},{},6.{},0.5,{}\n", i, 20 * (1 + i / 60) + 0.1 * (i % 5),
                            5 * (1 + i / 60), 20 + i % 3, interval);
    return text;
}

TEST(IntervalOfSeveralLoads, IsSplitWhereTheLoadChanges) {
    const TemporaryFolder folder;
    const auto file = folder.write("t.csv", three_loads("1"));
    std::vector<std::size_t> begins;
    for (const Step& step : split_steps(read_recording(file)))
        begins.push_back(step.begin);
    EXPECT_THAT(begins, ElementsAre(0, 60, 120));
    expect_told({view_of_file(file).roles[0].reason});
}

class ReadingsWithUnitsBelow : public testing::Test {
  protected:
    Measurements read(const std::string& table) {
        folder_.write("points.csv", table);
        folder_.write("study.toml", grains_table + "[[readings]]\nfile = \"points.csv\"\n");
        return read_measurements(read_study(folder_.path()));
    }
    TemporaryFolder folder_;
};

TEST_F(ReadingsWithUnitsBelow, AreThoseOfTheHeader) {
    const std::string rows = "1,400,0.001,60\n2,790,0.001,60\n3,1180,0.001,60\n";
    for (const std::string units : {"kPa,Pa,1,%", "[kPa],[Pa],[1],[%]", "kPa,Pa,-,%"}) {
        const Measurements all = read(
            "normal_stress,shear_stress,inertial_number,solid_fraction\n" + units + "\n" + rows);
        ASSERT_EQ(all.readings.size(), 3u) << units;
        EXPECT_DOUBLE_EQ(all.readings[1].condition.normal_stress, 2000);
        EXPECT_DOUBLE_EQ(all.readings[1].value(0), 790);
        EXPECT_DOUBLE_EQ(all.readings[1].value(1), 0.6);
        EXPECT_DOUBLE_EQ(all.readings[1].condition.inertial_number, 0.001);
        EXPECT_EQ(all.readings[1].origin.line, 4);
    }
}

/// Each reading counts, so that none is left out as a row of a recording is.
TEST_F(ReadingsWithUnitsBelow, AreRefusedWhereTheLastIsCut) {
    std::string text = "normal_stress [kPa],shear_stress [Pa],inertial_number,solid_fraction\n";
    for (int i = 0; i < 12; ++i)
        text += fmt::format("{},400,0.001,0.6\n", i + 1);
    expect_told({input_error([&] { read(text + "13,4"); })});
}

/// The study says that a recording ends within a row, and goes on without it.
TEST(CutRecording, IsSaidByTheStudy) {
    const TemporaryFolder folder;
    std::string text = recording_header;
    for (int i = 0; i < 60; ++i)
        text += fmt::format("{},3{}.{},5.0,4.0{},0.1\n", i, i % 4, i % 7, i % 3);
    folder.write("cut.csv", text + "60,30.0,5");
    folder.write("study.toml",
                 grains_table + cell_table("10 g") + "[[recording]]\nfile = \"cut.csv\"\n");
    const Measurements all = read_measurements(read_study(folder.path()));
    EXPECT_EQ(all.readings.size(), 1u);
    std::vector<Remark> notes = all.notes();
    std::erase_if(notes, [](const Remark& each) { return each.kind != Remark::Kind::ends_early; });
    expect_told(texts(notes));
}

/// A short row among the others is left out; it is not the end of the file.
TEST(CutRecording, EndsBehindItsLastStepAlone) {
    const TemporaryFolder folder;
    std::string text = table(true, 60);
    text.insert(text.find("30;5,01"), "30;5,01;6,2\n");
    folder.write("t.csv", text);
    folder.write("study.toml",
                 grains_table + cell_table("10 g") + "[[recording]]\nfile = \"t.csv\"\n");
    for (const Remark& each : read_measurements(read_study(folder.path())).notes())
        EXPECT_NE(each.kind, Remark::Kind::ends_early);
}

}  // namespace pendular::data_cut_files_test
