// Titles and other lines above the names of a table's columns, and rows between names and units.
#include "data/files/formats/preamble.h"

#include <gmock/gmock.h>

#include <cmath>

#include "data/files/formats/layouts.h"
#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_preamble_test {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* unit_row =
    "Time\tTorque\tNormal Force\tGap\tSpeed\n[s]\t[mNm]\t[N]\t[mm]\t[1/min]\n"
    "0\t20.1\t5.0\t6.20\t2.0\n1\t20.2\t5.0\t6.21\t2.0\n2\t20.3\t5.0\t6.20\t2.0\n";
constexpr const char* plain =
    "Time [s],Torque [mNm],Normal force [N],Gap [mm],Speed [rpm]\n"
    "0,20.1,5.0,6.20,2.0\n1,20.2,5.0,6.21,2.0\n2,20.3,5.0,6.20,2.0\n";

class Preamble : public testing::Test {
  protected:
    std::filesystem::path write(const std::string& text) { return folder_.write("t.txt", text); }
    /// Checks that a text is read as the three rows, the first of which is on a given line.
    void expect_rows(const std::string& text, int line) {
        const Recording recording = read_recording(write(text));
        ASSERT_EQ(recording.size(), 3u) << text;
        EXPECT_EQ(recording.line[0], line) << text;
        EXPECT_NEAR(recording.torque[1], 20.2e-3, 1e-12) << text;
        EXPECT_NEAR(recording.angular_velocity[1], 4 * M_PI / 60, 1e-12) << text;
    }
    TemporaryFolder folder_;
};

TEST_F(Preamble, StandsAboveNamesAndUnits) {
    for (const char* const title :
         {"run 12 glass 0.4 mm\n\n", "run 12, glass 0.4 mm\n\n", "run 12\t\t\t\t\n\n",
          "Radii\t21\t22\n\n", "# run 12\n# Inner radius: 21 mm\n"})
        expect_rows(std::string(title) + unit_row, 5);
    for (const char* const title :
         {"run 12 glass 0.4 mm\n\n", "run 12, glass 0.4 mm\n\n", "run 12,,,,\n\n",
          "Operator: N N\nDate,2026-11-28\n", "\"run 12\"\n# comment\n", "# a\n# b\n"})
        expect_rows(std::string(title) + plain, 4);
}

TEST_F(Preamble, LeavesTheColumnOfIntervals) {
    const std::string rows =
        "1\t0\t20.1\t5.0\t6.20\t2\n1\t1\t20.2\t5.0\t6.21\t2\n"
        "2\t2\t40.3\t9.0\t6.20\t2\n2\t3\t40.2\t9.0\t6.20\t2\n";
    const std::string names = "Interval\tTime\tTorque\tNormal Force\tGap\tSpeed\n",
                      units = "[1]\t[s]\t[mNm]\t[N]\t[mm]\t[1/min]\n";
    // All rows would be one step, whose speed and load change.
    EXPECT_THAT(read_recording(write("run 12\n\n" + names + units + rows)).interval,
                ElementsAre(1, 1, 2, 2));
}

TEST_F(Preamble, StatesFacts) {
    const BlockFile file = read_blocks(
        write(std::string("run 12\nInner radius: 21 mm\nOuter radius [mm]\t45\n\n") + unit_row));
    EXPECT_EQ(file.layout, "unit-row");
    EXPECT_EQ(file.fact("Inner radius"), "21 mm");
    EXPECT_EQ(file.fact("Outer radius [mm]"), "45");
    EXPECT_EQ(file.fact("title"), "run 12");
    EXPECT_EQ(file.facts[1].line, 2);
}

TEST_F(Preamble, IsNoneWhereTheNamesComeFirst) {
    for (const char* const text :
         {"Time [s],Torque [mN m],Remark\n0,1,Speed\n1,2,Gap\n", "Time [s],x,,\n0,1,2,3\n1,2,3,4\n",
          "\"a\n1,2\n3,4\n", "Time [s],Torque [mN m]\n,\nTorque [Pa],b\n1,2\n3,4\n"}) {
        SourceLines source{"t.csv", {}};
        std::string_view rest = text;
        for (std::size_t end = rest.find('\n'); end != std::string_view::npos;
             end = rest.find('\n')) {
            source.lines.push_back(rest.substr(0, end));
            rest.remove_prefix(end + 1);
        }
        const auto before = source.lines;
        BlockFile file;
        take_preamble(source, file);
        EXPECT_EQ(source.lines, before) << text;
        EXPECT_THAT(file.facts, IsEmpty());
    }
}

TEST_F(Preamble, OfAFileWithoutNamesIsRefused) {
    expect_told({input_error([&] { view_of_file(write("run 12,,\n0,1,2\n1,2,3\n")); }),
                 input_error([&] { view_of_file(write("a,b [mm],c\n0,1,2\n1,2,3\n")); })});
}

TEST_F(Preamble, MayContinueBetweenNamesAndUnits) {
    const auto path = write(
        "Point No.\tTime\tTorque\tNormal Force\tGap\tSpeed\n\tWaveform\tWaveform\t\t\t\n"
        "\t[s]\t[N·m]\t[N]\t[mm]\t[1/min]\n"
        "1\t0\t0.0201\t5.0\t6.20\t2.0\n2\t1\t0.0202\t5.0\t6.21\t2.0\n");
    EXPECT_THAT(view_of_file(path).missing, IsEmpty());
    const Recording recording = read_recording(path);
    ASSERT_EQ(recording.size(), 2u);
    EXPECT_NEAR(recording.torque[0], 0.0201, 1e-12);
    EXPECT_EQ(recording.line[0], 4);
}

TEST_F(Preamble, LeavesUnitsInTheHeaderOfCountedPoints) {
    const std::string rows = "1\t0\t0.0201\t5.0\t6.20\t2.0\n2\t1\t0.0202\t5.0\t6.21\t2.0\n";
    const Recording recording = read_recording(
        write("Point No.\tZeit [s]\tDrehmoment / N m\tNormalkraft [N]\tSpalt [mm]\tDrehzahl "
              "[U/min]\n" +
              rows));
    EXPECT_THAT(recording.torque, SizeIs(2));
    EXPECT_NEAR(recording.torque[0], 0.0201, 1e-12);
    // The line to paste keeps the unit that the file states.
    expect_told({input_error([&] {
        read_blocks(write("Point No.\tTime\tTorque [N m]\tNormal force\tGap [mm]\tSpeed\n" + rows));
    })});
}

}  // namespace pendular::data_preamble_test
