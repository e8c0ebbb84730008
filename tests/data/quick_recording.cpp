// The quick reader of plain recordings reads what the general reader reads.
#include "data/recordings/recording.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "data/files/file_access.h"
#include "data/files/formats/layouts.h"
#include "tests/support/golden.h"

namespace pendular::data_quick_recording_test {

class QuickRecording : public testing::Test {
  protected:
    std::optional<Recording> quick(const std::string& text, const FileFormat& format = {}) {
        file_ = folder_.write("t.csv", text);
        return quick_recording(file_, format);
    }
    TemporaryFolder folder_;
    std::filesystem::path file_;
};

const std::string header = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]";

std::string rows(int count, const std::string& more = "") {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    std::string text;
    for (int i = 0; i < count; ++i)
        text += fmt::format("{},{:.6g},{},{:.5e},0.5{}\n", 0.1 * i, 30 + normal(random),
                            5 + 0.01 * normal(random), 4 + 0.001 * normal(random), more);
    return text;
}

void expect_same(const Recording& a, const Recording& b) {
    EXPECT_EQ(a.file, b.file);
    EXPECT_EQ(a.line, b.line);
    EXPECT_EQ(a.unused_columns, b.unused_columns);
    for (auto member :
         {&Recording::time, &Recording::torque, &Recording::normal_force, &Recording::height,
          &Recording::angular_velocity, &Recording::interval, &Recording::shear_stress,
          &Recording::normal_stress, &Recording::shear_rate})
        EXPECT_EQ(a.*member, b.*member);  // bit for bit
}

TEST_F(QuickRecording, EqualsTheGeneralReaderBitForBit) {
    // The first has more than a part of the file that is read at a time (4 MB).
    const std::vector<std::string> files = {
        header + "\n" + rows(120'000),
        "\xEF\xBB\xBF" + header + ",Shear stress [kPa],Interval,Room [1]\n" + rows(50, ",1.5,3,7"),
        header + "\r\n1, 2 ,3,4,5\r\n\r\n2,2,3,4,5\r\n3,-2.5e-1,3,4,5",
        header + "\n# a comment\n1,2,3,4,5\n,,,,\n2,+2,3,4,5\n#\n",
        "Speed [rpm];Gap [um];Normal stress [Pa];Shear stress [Pa];Time "
        "[min]\n1;2;3;4;5\n1;2;3;4;6\n"};
    for (const std::string& text : files) {
        const auto recording = quick(text);
        ASSERT_TRUE(recording) << text.substr(0, 200);
        expect_same(*recording, recording_of(read_blocks(file_), {}));
        expect_same(*recording, read_recording(file_));
    }
}

TEST_F(QuickRecording, LeavesOtherFilesToTheGeneralReader) {
    const std::string begin = header + "\n" + rows(3);
    const std::vector<std::string> others = {
        begin + "0.3,1e20,5,4,1\n",
        begin + "0.3,,5,4,1\n",
        begin + "0.3,30,5,4\n",
        begin + "0.3,30,5,4,1,2\n",
        begin + "0.3,x,5,4,1\n",
        begin + "0.3,nan,5,4,1\n",
        begin + "0.05,30,5,4,1\n",
        begin + "0.3,30,5,-4,1\n",
        begin + "# a comment \xE9\n" + rows(1),
        begin + "# two\rlines\n" + rows(1),
        begin + "0.3,\"30\",5,4,1\n",
        begin + "\"0.3\",30,5,4,1\n",
        "# Ri: 21 mm\n" + begin,
        "Time [s];Torque [mN m];Normal force [N];Gap [mm];Speed "
        "[rpm]\n1;2,5;3;4;5\n2;2,5;3;4;5\n",
        "Time [s],Torque [mN m],Torque set [mN m],Normal force [N],Gap [mm],Speed [rpm]\n"
        "1,2,2,3,4,5\n2,2,2,3,4,5\n",
        "Time [s],Torque [mN m]\n1,2\n2,3\n",
        header + "\n",
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm],Temp\xE9rature\n" +
            rows(3, ",20"),  // Windows-1252
        std::string()};
    for (const std::string& text : others)
        EXPECT_FALSE(quick(text)) << text;
    FileFormat format;
    format.encoding = "windows-1252";
    EXPECT_FALSE(quick(begin, format));
    EXPECT_TRUE(quick(begin));
    for (const char* const name : {"trios.csv", "unit_row.csv", "headerless.csv", "rspace.csv"})
        EXPECT_FALSE(quick_recording(
            std::filesystem::path(PENDULAR_SOURCE_DIR) / "tests/data/formats" / name, {}));
}

TEST_F(QuickRecording, AveragesTheRowsOfLongFiles) {
    quick(header + "\n" + rows(10'000));
    const auto all = quick_recording(file_, {}), few = quick_recording(file_, {}, 1000);
    ASSERT_TRUE(all && few);
    EXPECT_EQ(all->averaged_rows, 1);
    EXPECT_EQ(few->averaged_rows, 16);
    ASSERT_EQ(few->size(), 625u);
    for (std::size_t k = 0; k < few->size(); ++k) {
        double torque = 0, time = 0;
        for (std::size_t i = 16 * k; i < 16 * (k + 1); ++i) {
            torque += all->torque[i] / 16;
            time += all->time[i] / 16;
        }
        ASSERT_EQ(few->line[k], all->line[16 * k]);
        ASSERT_NEAR(few->torque[k], torque, 1e-12);
        ASSERT_NEAR(few->time[k], time, 1e-9);
    }
}

TEST_F(QuickRecording, AveragesNoRowsOfTwoIntervals) {
    std::string text = header + ",Interval\n";
    for (int i = 0; i < 1000; ++i)
        text += fmt::format("{},{},5,4,1,{}\n", i, i < 333 ? 1 : 100, i < 333 ? 1 : 2);
    quick(text);
    const auto few = quick_recording(file_, {}, 100);
    ASSERT_TRUE(few);
    EXPECT_LT(few->size(), 100u);
    for (std::size_t k = 0; k < few->size(); ++k)
        EXPECT_NEAR(few->torque[k], few->interval[k] == 1 ? 0.001 : 0.1, 1e-15);
    // Where each row is an interval of its own, there is nothing to average.
    text = header + ",Interval\n";
    for (int i = 0; i < 1000; ++i)
        text += fmt::format("{},1,5,4,1,{}\n", i, i);
    quick(text);
    EXPECT_FALSE(quick_recording(file_, {}, 100));
}

TEST_F(QuickRecording, LeavesErrorsToTheGeneralReader) {
    EXPECT_FALSE(quick(header + "\n" + rows(3) + "0.3,1,2,x,4\n"));
    expect_told({input_error([&] { read_recording(file_); })});
}

class LongRecording : public QuickRecording {
  protected:
    const std::string start_ = header + ",Shear stress [Pa]\n0,30,5,4,0.5,---\n";
};

TEST_F(LongRecording, IsReadCellByCellWhereItMustBe) {
    const std::string blanks(1'000'000, ' ');  // few rows are long enough
    std::string text = start_;
    for (std::size_t i = 1; text.size() <= largest_table; ++i)
        text += fmt::format("{},30,5,4,0.5,100{}\n", i, blanks);
    const auto recording = quick(text + "\"9999\",30,5,4,0.5,\n");
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->torque.back(), 0.03);
    EXPECT_EQ(recording->shear_stress[1], 100);
    EXPECT_TRUE(std::isnan(recording->shear_stress.front()));
    EXPECT_TRUE(std::isnan(recording->shear_stress.back()));
}

TEST_F(LongRecording, IsRefusedAtTheCellThatIsWrong) {
    const auto refused = [&](const std::string& text) {
        const auto file = folder_.write("t.csv", text);
        std::filesystem::resize_file(file, largest_table + 1);
        return input_error([&] { quick_recording(file, {}); });
    };
    expect_told({refused(start_ + "1,x,5,4,0.5,1\n"), refused(start_ + "1,30,5,-4,0.5,1\n"),
                 refused(start_ + "1,30,5\n"), refused("Time [s],Gap [mm]\n1,2\n")});
}

}  // namespace pendular::data_quick_recording_test
