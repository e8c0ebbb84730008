// Missing values, slower columns and numbers of which it is not known what their marks mean.
#include "data/files/formats/missing_values.h"

#include <fmt/format.h>

#include <cmath>

#include "data/files/formats/layouts.h"
#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "data/remarks/wording.h"
#include "tests/support/golden.h"

namespace pendular::data_missing_values_test {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

const std::string header =
    "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s]\n";

class MissingValues : public testing::Test {
  protected:
    /// A recording with these cells of torque [mN m] and gap [mm].
    std::filesystem::path write(const std::vector<std::string>& torques,
                                const std::vector<std::string>& gaps = {},
                                const std::string& above = "") {
        std::string text = above + header;
        for (std::size_t i = 0; i < torques.size(); ++i)
            text += std::to_string(i) + "," + torques[i] + ",5," +
                    (gaps.empty() ? "6.25" : gaps[i]) + ",0.5\n";
        return folder_.write("t.csv", text);
    }
    TemporaryFolder folder_;
};

TEST_F(MissingValues, AreLeftOutAndCounted) {
    for (const std::string mark :
         {"", "NaN", "nan", "NA", "n/a", "#N/A", "null", "---", "-9999", "-9999.0"}) {
        const Recording recording = read_recording(write({"20", mark, "22", "23"}));
        EXPECT_THAT(recording.time, ElementsAre(0, 2, 3)) << mark;
        ASSERT_THAT(recording.left_out, SizeIs(1)) << mark;
        EXPECT_EQ(recording.left_out[0].kind, Remark::Kind::no_value);
        EXPECT_EQ(recording.left_out[0].quantity, "torque");
        EXPECT_THAT(recording.left_out[0].lines, ElementsAre(Lines{3, 3, 0}));
    }
}

TEST_F(MissingValues, AreNumbersThatTheUserOrTheHeaderDeclares) {
    FileFormat format;
    format.missing = {"-1"};
    EXPECT_THAT(read_recording(write({"20", "-1.0", "22"}), format).time, ElementsAre(0, 2));
    EXPECT_THAT(read_recording(write({"20", "-1.0", "22"})).time, ElementsAre(0, 1, 2));
    EXPECT_THAT(read_recording(write({"20", "-7", "22"}, {}, "# missing value: -7\n")).time,
                ElementsAre(0, 2));
}

TEST_F(MissingValues, AreDeclaredByASingularAlone) {
    for (const std::string line :
         {"# Missing values: 20\n", "# Fehlwerte: 20\n", "# No data points: 20\n"})
        EXPECT_THAT(read_recording(write({"20", "21"}, {}, line)).time, ElementsAre(0, 1)) << line;
    for (const std::string line :
         {"# No data value: 20\n", "# NODATA_value: 20\n", "# Fehlwert: 20\n"})
        EXPECT_THAT(read_recording(write({"20", "21"}, {}, line)).time, ElementsAre(1)) << line;
}

TEST_F(MissingValues, AreDeclaredInTheNumberStyleOfTheFile) {
    FileFormat format;
    format.missing = {"-99,9"};
    const auto path =
        folder_.write("c.csv",
                      "Time [s];Torque [mN m];Normal force [N];Gap [mm];Angular velocity [rad/s]\n"
                      "0;20,5;5;6,2;0,5\n1;-99,90;5;6,2;0,5\n2;20,5;5;6,2;0,5\n");
    EXPECT_THAT(read_recording(path, format).time, ElementsAre(0, 2));
}

TEST_F(MissingValues, AreNotTheNeighboursOfMeasuredOnes) {
    // A torque that reaches -10,001 may as well reach -9999.
    EXPECT_THAT(read_recording(write({"-9998", "-9999", "-10001"})).time, ElementsAre(0, 1, 2));
}

TEST_F(MissingValues, OfASlowerColumnLieOnLinesBetweenItsValues) {
    // The gap is recorded in every third row: 6 + 0.3 (row/3). Its mean is that of its own rows.
    std::vector<std::string> torques, gaps;
    for (int i = 0; i <= 36; ++i) {
        torques.push_back("20");
        gaps.push_back(i % 3 == 0 ? std::to_string(6 + 0.1 * i) : "");
    }
    const Recording recording = read_recording(write(torques, gaps));
    ASSERT_THAT(recording.height, SizeIs(37));
    // Nothing is left out, but a study says what was filled: 24 of 37 rows.
    ASSERT_THAT(recording.left_out, SizeIs(1));
    EXPECT_EQ(recording.left_out[0].kind, Remark::Kind::missing_values);
    EXPECT_EQ(recording.left_out[0].quantity, "height");
    EXPECT_EQ(recording.left_out[0].count, 24u);
    EXPECT_EQ(recording.left_out[0].of, 37u);
    for (std::size_t i = 0; i < 37; ++i)
        EXPECT_NEAR(recording.height[i], 1e-3 * (6 + 0.1 * static_cast<double>(i)), 1e-8);
}

TEST_F(MissingValues, OfASlowerColumnThatPausesAreLeftOut) {
    // Every second row has a gap up to row 20, then none up to row 42: more than three distances.
    std::vector<std::string> torques(44, "20"), gaps(44, "");
    for (std::size_t i = 0; i <= 20; i += 2)
        gaps[i] = "6.25";
    gaps[42] = "6.25";
    const Recording recording = read_recording(write(torques, gaps));
    EXPECT_THAT(recording.height, Each(testing::DoubleNear(6.25e-3, 1e-12)));
    // Rows 0 to 20 with one beyond, and row 42 with its neighbours.
    ASSERT_THAT(recording.time, SizeIs(25));
    EXPECT_EQ(recording.time[21], 21);
    EXPECT_EQ(recording.time[22], 41);
    EXPECT_EQ(recording.left_out.at(1).kind, Remark::Kind::no_value);
    EXPECT_EQ(recording.left_out.at(1).quantity, "height");
}

TEST_F(MissingValues, OfAColumnWithFewOrIrregularValuesAreLeftOut) {
    std::vector<std::string> torques(2000, "20"), few(2000, ""), irregular(2000, "");
    for (const std::size_t i : {0u, 1000u})
        few[i] = "6.25";
    for (std::size_t k = 0; k < 40; ++k)
        irregular[k * k] = "6.25";
    EXPECT_THAT(read_recording(write(torques, few)).time, ElementsAre(0, 1000));
    EXPECT_THAT(read_recording(write(torques, irregular)).time, SizeIs(40));
}

TEST_F(MissingValues, OfASpeedAreNeverFilled) {
    // Written with every third row, at speeds 1 and 2 rad/s.
    std::string text = header;
    for (int i = 0; i < 60; ++i)
        text += fmt::format("{},20,5,6.25,{}\n", i, i % 3 > 0 ? "" : i < 30 ? "1" : "2");
    const Recording recording = read_recording(folder_.write("t.csv", text));
    EXPECT_THAT(recording.angular_velocity, SizeIs(20));
    EXPECT_THAT(recording.angular_velocity, Each(testing::AnyOf(1.0, 2.0)));
}

TEST_F(MissingValues, AreNotFilledAcrossAChangeOfSetPoint) {
    // A load in every fourth row, of 5 N up to row 40 and of 10 N from row 44 on.
    std::string text = header;
    for (int i = 0; i < 80; ++i)
        text += fmt::format("{},20,{},6.25,1\n", i, i % 4 > 0 ? "" : i <= 40 ? "5" : "10");
    const Recording recording = read_recording(folder_.write("t.csv", text));
    EXPECT_THAT(recording.normal_force, Each(testing::AnyOf(5.0, 10.0)));
    EXPECT_THAT(recording.normal_force, SizeIs(79));  // without row 79, beyond the last
    // Gaps end where the speed changes, in row 42.
    text = header;
    for (int i = 0; i < 81; ++i)
        text += fmt::format("{},20,5,{},{}\n", i,
                            i % 4 > 0 ? ""
                            : i < 42  ? "6"
                                      : "8",
                            i < 42 ? 1 : 2);
    EXPECT_THAT(
        read_recording(folder_.write("g.csv", text)).height,
        Each(testing::AnyOf(testing::DoubleNear(6e-3, 1e-12), testing::DoubleNear(8e-3, 1e-12))));
}

class NumberMarks : public testing::Test {
  protected:
    std::string refused(const std::string& rows) {
        return input_error([&] {
            read_blocks(folder_.write("n.csv", "Normal stress [Pa];Shear stress [Pa]\n" + rows));
        });
    }
    TemporaryFolder folder_;
};

TEST_F(NumberMarks, ThatMayBeEitherAreRefusedAlike) {
    expect_told({refused("3.000;1.234\n4.000;2.345\n"), refused("3,000;1,234\n4,000;2,345\n"),
                 refused("3.000;1,234\n4.000;2,345\n")});
}

TEST_F(NumberMarks, AreDecidedByASingleNumber) {
    const auto first = [&](const std::string& text) {
        return read_blocks(folder_.write("n.csv", text)).blocks[0].table.rows[0].cells[0].text;
    };
    const std::string names = "Normal stress [Pa];Shear stress [Pa]\n";
    EXPECT_EQ(first(names + "3.000;1.2\n"), "3.000");
    EXPECT_EQ(first(names + "3.000;0.125\n"), "3.000");
    EXPECT_EQ(first(names + "3.000;1,2\n"), "3000");
    // Where commas divide the cells, no point divides thousands.
    EXPECT_EQ(first("Normal stress [Pa],Shear stress [Pa]\n3.000,1.234\n"), "3.000");
}

TEST_F(NumberMarks, OfALongRecordingAreRefusedToo) {
    std::string text =
        "Time [s];Torque [mN m];Normal force [N];Gap [mm];Angular velocity [rad/s]\n";
    for (const char* time : {"1", "2", "3"})
        text += std::string(time) + ";20.125;5.125;6.125;1.125\n";
    const auto path = folder_.write("r.csv", text);
    EXPECT_FALSE(quick_recording(path, {}));
    EXPECT_FALSE(input_error([&] { read_recording(path); }).empty());
    FileFormat format;
    format.decimal = ".";
    EXPECT_TRUE(quick_recording(path, format));
}

}  // namespace pendular::data_missing_values_test
