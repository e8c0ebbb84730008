#include <cmath>
#include <fstream>

#include "data/files/formats/layouts.h"
#include "data/files/text_file.h"
#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_formats_test {

using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Name and unit of each column that is read as a quantity: "torque [mN·m]".
std::vector<std::string> used_columns(const Block& block) {
    std::vector<std::string> result;
    for (const BlockColumn& column : block.columns)
        if (!column.quantity.empty()) result.push_back(column.quantity + " [" + column.unit + "]");
    return result;
}

std::vector<std::size_t> row_counts(const BlockFile& file) {
    std::vector<std::size_t> result;
    for (const Block& block : file.blocks)
        result.push_back(block.table.rows.size());
    return result;
}

class ReadBlocks : public testing::Test {
  protected:
    BlockFile read(const std::string& content, const FileFormat& format = {}) {
        return read_blocks(folder_.write("t.csv", content), format);
    }
    std::string error(const std::string& content, const FileFormat& format = {}) {
        return input_error([&] { read(content, format); });
    }
    TemporaryFolder folder_;
};

TEST_F(ReadBlocks, RecogniseRheoCompassInAnyLanguageAndEncoding) {
    const std::string text = read_text(look_alike("rheocompass_fr.txt"));
    std::u16string wide;
    std::string little = "\xFF\xFE", latin;
    for (std::size_t i = 0; i < text.size(); ++i) {
        // Letters of the look-alike are ASCII or take two bytes in UTF-8.
        const auto byte = static_cast<unsigned char>(text[i]);
        const int code = byte < 0x80 ? byte : ((byte & 0x1F) << 6) | (text[++i] & 0x3F);
        little += {static_cast<char>(code), '\0'};
        latin += static_cast<char>(code);
    }
    std::set<std::string> reasons;
    for (const std::string& content : {text, little, latin}) {
        const BlockFile file = read(content);
        EXPECT_EQ(file.layout, "rheocompass");
        EXPECT_EQ(file.delimiter, '\t');
        EXPECT_EQ(file.numbers.decimal, ',');
        ASSERT_THAT(row_counts(file), ElementsAre(3, 2, 3));
        EXPECT_THAT(used_columns(file.blocks[0]),
                    ElementsAre("time [s]", "torque [mN·m]", "normal_force [N]", "height [mm]",
                                "rotational_speed [1/min]"));
        EXPECT_EQ(file.blocks[0].test, "essai 1, Courbe 1");
        EXPECT_EQ(file.blocks[2].test, "essai 1, Courbe 2");
        ASSERT_THAT(file.skipped, SizeIs(1));
        reasons.insert(text_of(file.skipped[0]));
    }
    std::string apart = text;  // a line between the begin of an interval and its names
    for (std::size_t at = apart.find("\nInterval "); at != std::string::npos;
         at = apart.find("\nInterval ", at + 3))
        apart.insert(at + 1, "\r\n");
    EXPECT_THAT(row_counts(read(apart)), ElementsAre(3, 2, 3));
    EXPECT_EQ(used_columns(read(apart).blocks[0]), used_columns(read(text).blocks[0]));
    EXPECT_EQ(read(text).encoding, "UTF-8");
    EXPECT_EQ(read(little).encoding, "UTF-16LE");
    EXPECT_EQ(read(latin).encoding, "windows-1252");
    const BlockFile cut = read(little.substr(0, little.size() - 25));  // within a character
    EXPECT_EQ(cut.encoding, "UTF-16LE");
    EXPECT_EQ(cut.blocks.size(), 3u);
    expect_told({reasons.begin(), reasons.end()});
}

TEST_F(ReadBlocks, KeepTestsOfOneFileApart) {
    const Recording recording = read_recording(look_alike("rheocompass_fr.txt"));
    EXPECT_THAT(recording.interval, ElementsAre(1, 1, 1, 2, 2, 3, 3, 3));
    EXPECT_THAT(recording.torque[0], DoubleNear(0.0301, 1e-12));
    EXPECT_THAT(recording.height[0], DoubleNear(0.012345, 1e-12));
    EXPECT_THAT(recording.normal_force[0], DoubleNear(1.25, 1e-12));
    EXPECT_THAT(recording.angular_velocity[0], DoubleNear(2 * M_PI / 120, 1e-12));
    EXPECT_THAT(recording.left_out, SizeIs(1));
}

TEST_F(ReadBlocks, ReadRheoplusSeries) {
    const BlockFile file = read_blocks(look_alike("rheoplus.txt"));
    EXPECT_EQ(file.layout, "rheoplus");
    EXPECT_THAT(row_counts(file), ElementsAre(3, 2));
    EXPECT_EQ(file.blocks[1].test, "series 2");
    EXPECT_THAT(used_columns(file.blocks[0]),
                ElementsAre("shear_stress [Pa]", "torque [µNm]", "time [s]", "normal_force [N]"));
    const IntervalSeries series = series_of(file.blocks[0]);
    EXPECT_THAT(series.torque[0], DoubleNear(1214.5e-6, 1e-12));  // "1,214.5": thousands
    EXPECT_THAT(series.shear_stress, ElementsAre(15, 25, 35));    // the first of two columns
    EXPECT_EQ(file.fact("- Norm. Css [Pa/mNm]"), "9,945.692");
}

TEST_F(ReadBlocks, ReadTriosSteps) {
    for (const char* const name : {"trios.csv", "trios.txt"}) {
        const BlockFile file = read_blocks(look_alike(name));
        EXPECT_EQ(file.layout, "trios");
        EXPECT_THAT(row_counts(file), ElementsAre(3, 2));
        EXPECT_EQ(file.blocks[0].name, "Peak hold - 1");
        EXPECT_EQ(file.fact("stress constant"), "79577.5 Pa/N.m");
        const IntervalSeries series = series_of(file.blocks[0]);
        EXPECT_THAT(series.time[0], DoubleNear(90, 1e-9));
        EXPECT_THAT(series.height[0], DoubleNear(1e-3, 1e-12));
        EXPECT_THAT(series.torque[0], DoubleNear(101.5e-6, 1e-12));
        EXPECT_THAT(series.normal_force[0], DoubleNear(2.5, 1e-12));
        EXPECT_THAT(used_columns(file.blocks[1]),
                    ElementsAre("shear_stress [Pa]", "shear_rate [1/s]", "time [min]"));
    }
    // The step without torque, force, gap and speed is left out of the recording and listed.
    const Recording recording = read_recording(look_alike("trios.csv"));
    EXPECT_EQ(recording.size(), 3u);
    ASSERT_THAT(recording.left_out, SizeIs(1));
    expect_told({text_of(recording.left_out[0])});
}

TEST_F(ReadBlocks, ReadRSpaceActions) {
    const BlockFile file = read_blocks(look_alike("rspace.csv"));
    EXPECT_EQ(file.layout, "rspace");
    EXPECT_EQ(file.numbers.decimal, ',');
    EXPECT_THAT(row_counts(file), ElementsAre(3, 3));
    EXPECT_EQ(file.blocks[1].name, "Flow Up");
    const IntervalSeries series = series_of(file.blocks[0]);
    EXPECT_THAT(series.time, ElementsAre(1, 2, 3));  // of the action, not of the sequence
    EXPECT_THAT(series.torque[0], DoubleNear(1.284e-3, 1e-12));
    EXPECT_THAT(series.shear_rate[0], DoubleNear(47.57, 1e-9));
}

TEST_F(ReadBlocks, ReadLabViewWithUnitsOfItsOwnLine) {
    const std::string begin =
        "LabVIEW Measurement\t\nWriter_Version\t2\nSeparator\tTab\nDecimal_Separator\t,\n"
        "X_Columns\tOne\nOperator\tlab\n***End_of_Header***\t\n\t\n";
    const std::string segment =
        "Channels\t3\t\t\nSamples\t3\t3\t3\nY_Unit_Label\tN\tmNm\tmm\nX_"
        "Dimension\tTime\tTime\tTime\n"
        "X0\t0,25\t0,25\t0,25\nDelta_X\t0,5\t0,5\t0,5\n***End_of_Header***\t\t\t\n"
        "X_Value\tNormal force\tTorque\tGap\tComment\n";
    const std::string rows =
        "0,0\t5,1\t12,1\t11,5\tbegun\n0,5\t5,2\t12,2\t11,6\n1,0\t5,3\t12,3\t11,7\n";
    const BlockFile file = read(begin + segment + rows + "\n" + segment + rows);
    ASSERT_THAT(file.blocks, SizeIs(2));
    EXPECT_THAT(used_columns(file.blocks[1]),
                ElementsAre("time [s]", "normal_force [N]", "torque [mNm]", "height [mm]"));
    EXPECT_EQ(file.blocks[1].table.rows[2].cells[2].text, "12.3");
    EXPECT_EQ(file.fact("Operator"), "lab");
    EXPECT_EQ(file.blocks[1].test, "segment 2");
    // A fault in a row neither hides it nor those behind it.
    const BlockFile faulty = read(begin + segment +
                                  "0,0\t5,1\t12,1\t11,5\nbad\t5,2\t12,2\t11,6\n"
                                  "1,0\t5,3\t12,3\t11,7\n");
    EXPECT_THAT(faulty.blocks[0].table.rows, SizeIs(3));
    // Without a column of times they follow from the first one and their distance.
    const BlockFile untimed = read(begin + segment + "\t5,1\t12,1\t11,5\n\t5,2\t12,2\t11,6\n");
    EXPECT_EQ(untimed.blocks[0].table.rows[1].cells[0].text, "0.75");
}

TEST_F(ReadBlocks, ReadRheoWinTablesSideBySide) {
    const BlockFile file = read_blocks(look_alike("rheowin.csv"));
    EXPECT_EQ(file.layout, "rheowin");
    EXPECT_THAT(row_counts(file), ElementsAre(2, 2, 2, 2));
    EXPECT_EQ(file.blocks[2].test, "table 2");
    EXPECT_THAT(used_columns(file.blocks[0]),
                ElementsAre("time [s]", "torque [mNm]", "normal_force [N]", "height [mm]"));
    EXPECT_THAT(series_of(file.blocks[2]).torque[0], DoubleNear(4.25e-3, 1e-12));
    EXPECT_EQ(file.blocks[2].columns[5].name, "G\"");  // a quote inside a header cell
}

TEST_F(ReadBlocks, ReadARowOfUnitsAndSplitWherePointsRestart) {
    const BlockFile file = read_blocks(look_alike("unit_row.csv"));
    EXPECT_EQ(file.layout, "unit-row");
    EXPECT_THAT(row_counts(file), ElementsAre(25, 25));
    const Recording recording = read_recording(look_alike("unit_row.csv"));
    EXPECT_EQ(recording.interval.front(), 1);
    EXPECT_EQ(recording.interval.back(), 2);
    EXPECT_THAT(recording.angular_velocity[0], DoubleNear(0.005 * 2 * M_PI / 60, 1e-12));
}

TEST_F(ReadBlocks, DivideATableWithARowOfUnitsByItsColumnOfIntervals) {
    const TemporaryFolder folder;
    const auto path = folder.path() / "messung.csv";
    std::ofstream(path) << "Abschnitt;Zeit;Drehmoment;Normalkraft;Spaltweite;Drehzahl\n"
                           ";[s];[mNm];[N];[mm];[1/min]\n"
                           "1;0,1;5,2;3,4;15,0;4,4\n1;0,2;5,3;3,4;15,0;4,4\n"
                           "2;0,3;6,2;3,4;15,1;44,4\n2;0,4;6,3;3,4;15,1;44,4\n";
    const Recording recording = read_recording(path);
    EXPECT_THAT(recording.interval, ElementsAre(1, 1, 2, 2));
    // A role that the user states is one of these intervals.
    FileFormat format;
    format.roles = {{"preshear", {"1"}}};
    EXPECT_THAT(read_recording(path, format).interval, ElementsAre(2, 2));
}

TEST_F(ReadBlocks, RefuseMissingUnitsUnlessStated) {
    const auto path = look_alike("no_units_damaged_torque.csv");
    const std::string message = input_error([&] { read_blocks(path); });
    expect_told({message});
    FileFormat format;
    format.columns = {"Point No. [1]",     "Time [s]",           "Gap [mm]",
                      "Normal Force [N]",  "Normal Stress [Pa]", "Torque [mN m]",
                      "Shear Stress [Pa]", "Speed [1/min]"};
    const BlockFile file = read_blocks(path, format);
    EXPECT_THAT(row_counts(file), ElementsAre(25, 25));
    EXPECT_EQ(file.blocks[1].number, 2);  // of the row "2,25"
    EXPECT_EQ(file.blocks[1].declared_rows, 25u);
}

TEST_F(ReadBlocks, ReadNumbersWithoutHeaderAsTheUserStates) {
    FileFormat format;
    expect_told({input_error([&] { read_blocks(look_alike("headerless.csv")); }),
                 input_error([&] { read_blocks(look_alike("transposed.csv")); })});
    format.columns = {"Time [s]", "Torque [N m]"};
    for (const char* const name : {"headerless.csv", "transposed.csv"}) {
        const BlockFile file = read_blocks(look_alike(name), format);
        ASSERT_THAT(row_counts(file), ElementsAre(30)) << name;
        const IntervalSeries series = series_of(file.blocks[0]);
        EXPECT_THAT(series.time[29], DoubleNear(3, 1e-12));
        EXPECT_THAT(series.torque[29], DoubleNear(0.03, 1e-12));
    }
}

TEST_F(ReadBlocks, LeaveOutRowsThatAreCutShort) {
    const auto file = folder_.write("cut.csv",
                                    "Point No.,Normal Stress,Shear Stress\n,[Pa],[Pa]\n"
                                    "1,1000,300\n2,10\n3,1000,310\n4,1000,\n5,1000\n");
    const BlockFile read = read_blocks(file);
    ASSERT_THAT(row_counts(read), ElementsAre(4));  // the cell of row 4 is empty, not missing
    ASSERT_EQ(read.skipped.size(), 1u);
    EXPECT_EQ(read.skipped[0].first_line(), 4);
    expect_told({text_of(read.skipped[0])});
}

TEST_F(ReadBlocks, RefuseUnitsThatAreNone) {
    const auto file = folder_.write("unit.csv",
                                    "Point No.,Normal Stress,Shear Stress\n,[Pa],[quux]\n"
                                    "1,1000,300\n2,1000,310\n");
    expect_told({input_error([&] { read_blocks(file); })});
}

TEST_F(ReadBlocks, ReadReportsOnYieldLoci) {
    const FileView view = view_of_file(look_alike("yield_locus_report.txt"));
    EXPECT_EQ(view.file.layout, "yield-locus-report");
    ASSERT_EQ(view.file.blocks.size(), 7u);
    EXPECT_EQ(view.file.blocks[0].test, "0.8 mm beads");
    const std::vector<std::string> roles = {"preshear", "failure", "failure", "failure",
                                            "preshear", "failure", "failure"};
    const int numbers[] = {2, 4, 8, 12, 14, 16, 20};
    for (std::size_t k = 0; k < 7; ++k) {
        EXPECT_EQ(view.roles[k].role, roles[k]);
        EXPECT_EQ(view.file.blocks[k].number, numbers[k]);
    }
    ASSERT_EQ(view.loci.size(), 2u);
    const YieldLocus &first = view.loci[0], &second = view.loci[1];
    EXPECT_NEAR(first.line.value().cohesion, 50, 1e-9);
    EXPECT_NEAR(std::tan(first.line->slope_angle), 0.5, 1e-9);
    EXPECT_NEAR(first.preshear.value().bulk_density.value(), 1450, 1e-9);
    EXPECT_NEAR(second.preshear.value().shear_stress, 2400, 1e-9);
    EXPECT_NEAR(second.preshear->bulk_density.value(), 1480, 1e-9);
    EXPECT_TRUE(second.preshear->plateau);
    EXPECT_FALSE(first.points[0].at_end);
    EXPECT_NEAR(view.series[4].height.at(0), 0.0123, 1e-12);
}

TEST_F(ReadBlocks, RefuseWhatIsNoRecording) {
    const auto empty = folder_.write("report.txt", "Yield locus function\nCohesion: 50 Pa\n");
    expect_told({input_error([&] { read_blocks(empty); }),
                 input_error([] { read_blocks(look_alike("nested_lists.csv")); })});
}

TEST_F(ReadBlocks, DecideTheDecimalMarkOfTheFile) {
    const auto value = [&](const std::string& rows, const FileFormat& format = {}) {
        return read("Torque [N m];x\n" + rows, format).blocks[0].table.rows[0].cells[0].text;
    };
    EXPECT_EQ(value("1,25;1\n"), "1.25");
    EXPECT_EQ(value("1.25;1\n"), "1.25");
    EXPECT_EQ(value("1.234,5;1\n"), "1234.5");
    EXPECT_EQ(value("1,234.5;1\n"), "1234.5");
    EXPECT_EQ(value("1,234;2.5\n"), "1234");   // the other number has a decimal point
    EXPECT_EQ(value("1,234;2,5\n"), "1.234");  // the other number has a decimal comma
    EXPECT_EQ(value("0,123;1\n"), "0.123");
    EXPECT_EQ(value("1234,567;1\n"), "1234.567");
    EXPECT_EQ(value("1 234,5;1\n"), "1234.5");
    EXPECT_EQ(value("4,75275E+003;1\n"), "4.75275E+003");
    FileFormat comma;
    comma.decimal = ",";
    EXPECT_EQ(value("1,234;1\n", comma), "1.234");
}

TEST_F(ReadBlocks, RefuseADecimalMarkThatNothingDecides) {
    expect_told({error("Torque [N m];x\n2,800;1\n3,100;2\n"),
                 error("Torque [N m];x\n2,85;1\n3.15;2\n"),
                 // "3.100" may have a thousands separator as well as "2,800".
                 error("Torque [N m];x\n2,800;3.100\n")});
}

TEST_F(ReadBlocks, RefuseNumbersThatContradictTheStatedDecimalMark) {
    expect_told({error("Torque [N m];x\n1.234;1\n1.5;1\n", {.decimal = ","}),
                 error("Torque [N m];x\n1,5;1\n", {.decimal = "."})});
}

TEST_F(ReadBlocks, DoNotTakePointsWithoutStressesForAnnouncedIntervals) {
    // Points 10 and 20 have a time and no stress; "2,25" announces the second interval.
    std::string text = "Point No.,Time,Shear Stress\n,[s],[Pa]\n";
    for (int i = 1; i <= 25; ++i)
        text += std::to_string(i) + "," + std::to_string(i) + (i % 10 == 0 ? ",\n" : ",300\n");
    text += "2,25,\n1,1,310\n2,2,320\n";
    const BlockFile file = read(text);
    EXPECT_THAT(row_counts(file), ElementsAre(25, 2));
    EXPECT_EQ(file.blocks[1].number, 2);
}

TEST_F(ReadBlocks, ListRowsThatBelongToNoSegmentOrInterval) {
    std::string rheowin = "t in s,M in mNm\n1|1,1.5,3.25\n1:2,2.5,3.25\n1|3,3.5,3.25\n";
    rheowin.replace(0, 15, ",t in s,M in mNm");
    const BlockFile segments = read(rheowin);
    ASSERT_THAT(segments.skipped, SizeIs(1));
    EXPECT_EQ(segments.skipped[0].first_line(), 3);
    std::string compass = read_text(look_alike("powder_cell.txt"));
    const std::size_t second_row = compass.find("\n\t2\t");
    ASSERT_NE(second_row, std::string::npos);
    compass.insert(second_row, "\n");
    EXPECT_THAT(read(compass).skipped,
                Contains(testing::Field(&Remark::kind, Remark::Kind::after_interval)));
}

/// rSpace file whose actions alternate, so that each row is an interval.
std::string alternating_intervals(int intervals, int columns) {
    std::string text = "Action Name";
    for (int i = 1; i < columns; ++i)
        text += ";c" + std::to_string(i);
    text += "\n";
    for (int i = 0; i < intervals; ++i)
        text += i % 2 == 0 ? "a;1\n" : "b;1\n";
    return text;
}

TEST_F(ReadBlocks, LimitIntervalsAndIntervalsTimesColumns) {
    EXPECT_EQ(read(alternating_intervals(10'000, 2)).blocks.size(), 10'000u);
    expect_told({error(alternating_intervals(10'001, 2)), error(alternating_intervals(1200, 900))});
}

TEST_F(ReadBlocks, LimitRowsTimesColumns) {
    const auto rows = [](int count) {
        std::string text = "Action Name";
        for (int i = 1; i < 1000; ++i)
            text += ";c" + std::to_string(i);
        text += "\n";
        for (int i = 0; i < count; ++i)
            text += "a;1\n";  // cells that are missing are kept as empty ones
        return text;
    };
    EXPECT_EQ(read(rows(20)).counts.cells, 20'000u);
    expect_told({error(rows(20'001))});
}

TEST_F(ReadBlocks, CountPointsThatWereLeftOutWithTheirInterval) {
    std::string text;
    const auto add_interval = [&](int number, int valued, int all) {
        text += "Interval and data points:\t" + std::to_string(number) +
                "\t3\n\tTime\tTorque\n\t[s]\t[mN m]\n";
        for (int i = 1; i <= all; ++i)
            text += "\t" + std::to_string(i) + (i > valued ? "\t\n" : "\t1\n");
        text += "\n";
    };
    add_interval(1, 2, 3);
    add_interval(2, 3, 3);
    add_interval(3, 1, 3);
    add_interval(4, 2, 2);
    const FileView view = view_of_file(folder_.write("t.txt", text));
    ASSERT_THAT(view.findings, SizeIs(1));
    expect_told({text_of(view.findings[0])});
}

TEST_F(ReadBlocks, DetectShiftJis) {
    // Japanese header words for torque, normal force and time, in Shift-JIS.
    const std::string words =
        "\x83\x67\x83\x8b\x83\x4e,\x96\x40\x90\xfc\x97\xcd,\x8e\x9e\x8a\xd4,"
        "\x89\xf1\x93\x5d\x91\xac\x93\x78,\x91\xaa\x92\xe8\x93\x5f\x94\xd4\x8d\x86";
    const BlockFile file = read("a,b,c,d," + words + "\n1,2,3,4,5,6,7,8,9\n");
    EXPECT_EQ(file.encoding, "Shift_JIS");
    EXPECT_EQ(file.blocks[0].columns[4].name, "トルク");
    FileFormat format;
    format.encoding = "no-such-encoding";
    expect_told({error("a,b\n1,2\n", format)});
}

}  // namespace pendular::data_formats_test
