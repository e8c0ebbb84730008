// Workbooks (.xlsx) of the layouts that text files have.
#include "data/files/workbook.h"

#include <cstdlib>

#include "data/files/cell_formats.h"
#include "data/files/file_access.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/sheets.h"
#include "data/files/sheet_path.h"
#include "data/recordings/checks.h"
#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "data/remarks/wording.h"
#include "tests/support/golden.h"

namespace pendular::data_workbook_test {

using testing::ElementsAre;
using testing::SizeIs;

const std::string tests = PENDULAR_SOURCE_DIR "/tests/data/";

class Workbook : public testing::Test {
  protected:
    /// Workbook with a sheet for each name and CSV file.
    std::filesystem::path workbook(const std::string& sheets) {
        const auto path = folder_.path() / "book.xlsx";
        const std::string command =
            "python3 " + tests + "make_workbook.py " + path.string() + " " + sheets;
        EXPECT_EQ(std::system(command.c_str()), 0) << command;
        return path;
    }
    std::filesystem::path of_table(const std::string& rows) {
        return workbook("Data=" + folder_.write("rows.csv", rows).string());
    }
    TemporaryFolder folder_;
};

TEST_F(Workbook, IsReadInEachLayoutAsTheTextIs) {
    for (const std::string name : {"powder_cell.txt", "rheocompass_fr.txt", "rheoplus.txt",
                                   "rspace.csv", "trios.csv", "trios.txt", "unit_row.csv"}) {
        const BlockFile text = read_blocks(tests + "formats/" + name);
        const BlockFile sheet = read_blocks(workbook("Data=" + tests + "formats/" + name));
        EXPECT_EQ(sheet.layout, text.layout) << name;
        EXPECT_EQ(sheet.delimiter, '\t') << name;
        ASSERT_EQ(sheet.blocks.size(), text.blocks.size()) << name;
        for (std::size_t k = 0; k < text.blocks.size(); ++k) {
            const Block &a = text.blocks[k], &b = sheet.blocks[k];
            EXPECT_EQ(b.test, a.test) << name;
            EXPECT_EQ(b.name, a.name) << name;
            ASSERT_EQ(b.table.rows.size(), a.table.rows.size()) << name;
            const IntervalSeries from_text = series_of(a), from_sheet = series_of(b);
            EXPECT_EQ(from_sheet.line, from_text.line) << name;
            EXPECT_EQ(from_sheet.time, from_text.time) << name;
            EXPECT_EQ(from_sheet.torque, from_text.torque) << name;
            EXPECT_EQ(from_sheet.shear_stress, from_text.shear_stress) << name;
        }
    }
}

const std::string header =
    "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s]\n";

TEST_F(Workbook, HasTheSheetThatIsNamed) {
    const auto first = folder_.write("first.csv", "Torque [N m],x\n1,2\n");
    const auto second = folder_.write("second.csv", "Torque [N m],x\n0.001,4\n");
    const auto book = workbook("'One & only'=" + first.string() + " Two=" + second.string());
    EXPECT_EQ(read_blocks(book).blocks[0].table.rows[0].cells[0].text, "1");
    FileFormat format;
    format.sheet = "Two";
    EXPECT_EQ(read_blocks(book, format).blocks[0].table.rows[0].cells[0].text, "0.001");
    EXPECT_EQ(read_blocks(book, format).file, book.string() + " [Two]");
    format.sheet = "Three";
    expect_told({input_error([&] { read_blocks(book, format); }),
                 input_error([&] { read_blocks(first, format); })});
}

/// A number is stored without zeros behind its decimals, so that such a text is none.
TEST_F(Workbook, RefusesTextsThatMayHaveThousandsSeparators) {
    const std::string names = "Normal stress [Pa],Shear stress [Pa]\n500,500\n";
    EXPECT_THAT(input_error([&] {
                    read_blocks(of_table(names + "text:1.000,800\ntext:2.000,text:1.400\n"));
                }),
                testing::HasSubstr("\"1.000\" can be 1.000"));
    for (const char* const cells : {"1.000,800\n2.000,1.400\n", "text:1.50,text:1.000\n"})
        EXPECT_NO_THROW(read_blocks(of_table(names + cells))) << cells;
}

/// A cell that shows "30 %" stores 0.3, which is right below a header without a unit.
TEST_F(Workbook, HasThePercentThatItsCellsShow) {
    const auto fractions = [&](const std::string& header, const std::string& cell) {
        const auto book = of_table("Normal stress [Pa],Shear stress [Pa]," + header +
                                   "\n1000,500," + cell + "\n2000,1000,58\n");
        const BlockFile file = read_blocks(book);
        std::vector<std::string> texts;
        for (const Row& row : file.blocks.at(0).table.rows)
            texts.push_back(row.cells.at(2).text);
        return texts;
    };
    EXPECT_THAT(fractions("Solid fraction [%]", "percent:0.57"), ElementsAre("57", "58"));
    EXPECT_THAT(fractions("Solid fraction [percent]", "percent:0.573"), ElementsAre("57.3", "58"));
    EXPECT_THAT(fractions("Wassergehalt [%]", "percent:0.57"), ElementsAre("57", "58"));
    EXPECT_THAT(fractions("Solid fraction", "percent:0.57"), ElementsAre("0.57", "58"));
    EXPECT_THAT(fractions("Solid fraction [1]", "percent:0.57"), ElementsAre("0.57", "58"));
    EXPECT_THAT(fractions("Solid fraction [%]", "57"), ElementsAre("57", "58"));
    EXPECT_TRUE(format_of_code("0.0\\ %").percent);
    EXPECT_TRUE(format_of_code("0%;-0%").percent);
    EXPECT_FALSE(format_of_code("0.0\" %\"").percent);  // the sign alone, as text
    EXPECT_FALSE(format_of_code("0.0\\%").percent);
}

/// One changed digit leaves XML well-formed: only the checksum tells.
TEST_F(Workbook, IsRefusedWithAWrongChecksum) {
    const auto book = of_table("Torque [N m],x\n0.0123,4\n");
    // As `zip -0` stores a part, without compression.
    const std::string store =
        "python3 -c \"import sys, zipfile\n"
        "old = zipfile.ZipFile(sys.argv[1]); new = zipfile.ZipFile(sys.argv[2], 'w')\n"
        "[new.writestr(n, old.read(n)) for n in old.namelist()]; new.close()\" ";
    const auto stored = folder_.path() / "stored.xlsx";
    ASSERT_EQ(std::system((store + book.string() + " " + stored.string()).c_str()), 0);
    std::string bytes = content_of(stored);
    EXPECT_EQ(read_blocks(stored).blocks[0].table.rows[0].cells[0].text, "0.0123");
    const std::size_t at = bytes.find("0.0123");
    ASSERT_NE(at, std::string::npos);
    bytes[at + 3] = '7';
    const auto damaged = folder_.write("damaged.xlsx", bytes);
    const auto cut = folder_.write("cut.xlsx", bytes.substr(0, bytes.size() / 2));
    expect_told(
        {input_error([&] { read_blocks(damaged); }), input_error([&] { read_blocks(cut); })});
}

TEST_F(Workbook, ChoosesSheetsWithATableOrByAPattern) {
    const auto table = folder_.write("t.csv", "Torque [N m],x\n1,2\n");
    const auto cover = folder_.write("c.csv", "Powder,glass\nDate,today\nMass,20\n");
    const auto book = workbook("Cover=" + cover.string() + " '3 kPa'=" + table.string() +
                               " '6 kPa'=" + table.string() + " Rest=" + table.string());
    const auto names = [](const ChosenSheets& chosen) {
        std::vector<std::string> result;
        for (const auto& path : chosen.read)
            result.push_back(as_sheet(path)->sheet);
        return result;
    };
    const ChosenSheets all = chosen_sheets(book, "");
    EXPECT_THAT(names(all), ElementsAre("3 kPa", "6 kPa", "Rest"));
    EXPECT_THAT(all.others, ElementsAre("Cover"));
    EXPECT_EQ(file_to_open(all.read[0]), book);
    const ChosenSheets some = chosen_sheets(book, "* kPa");
    EXPECT_THAT(names(some), ElementsAre("3 kPa", "6 kPa"));
    EXPECT_THAT(some.others, ElementsAre("Cover", "Rest"));
    EXPECT_THAT(names(chosen_sheets(workbook("Cover=" + cover.string()), "")),
                ElementsAre("Cover"));
}

TEST_F(Workbook, KeepsHiddenSheetsBackUnlessTheyAreNamed) {
    const std::string table = "=" + folder_.write("t.csv", "Torque [N m],x\n1,2\n").string() + " ";
    const auto book = workbook("hidden:'1 kPa'" + table + "'2 kPa'" + table + "veryHidden:'3 kPa'" +
                               table + "'4 kPa'" + table);
    for (const std::string wanted : {"", "* kPa"}) {
        const ChosenSheets chosen = chosen_sheets(book, wanted);
        ASSERT_THAT(chosen.read, SizeIs(2)) << wanted;
        EXPECT_EQ(as_sheet(chosen.read[0])->sheet, "2 kPa");
        EXPECT_EQ(as_sheet(chosen.read[1])->sheet, "4 kPa");
        EXPECT_THAT(chosen.others, ElementsAre("1 kPa", "3 kPa")) << wanted;
    }
    ASSERT_THAT(chosen_sheets(book, "3 kPa").read, SizeIs(1));
    EXPECT_EQ(as_sheet(chosen_sheets(book, "3 kPa").read[0])->sheet, "3 kPa");
}

TEST_F(Workbook, IsNoFileWhoseNameEndsWithBrackets) {
    const auto file = folder_.write("run [2]", "Torque [N m],x\n1,2\n");
    EXPECT_FALSE(as_sheet(file));
    EXPECT_EQ(read_blocks(file).blocks[0].table.rows.size(), 1u);
    EXPECT_EQ(as_sheet(folder_.path() / "other [2]")->sheet, "2");
}

/// Rows of a recording with the given first cells and torques.
std::string rows_of(const std::vector<std::string>& times, const std::string& torque = "20") {
    std::string text;
    for (const std::string& time : times)
        text += time + "," + torque + ",5,6,0.5\n";
    return text;
}

TEST_F(Workbook, GivesEachSheetAsARecordingOfAStudy) {
    const auto low = folder_.write("low.csv", header + rows_of({"0", "1", "2"}));
    const auto high = folder_.write("high.csv", header + rows_of({"0", "1", "2"}, "40"));
    const auto cover = folder_.write("cover.csv", "Powder,glass\n");
    workbook("'3 kPa'=" + low.string() + " '6 kPa'=" + high.string() + " Cover=" + cover.string());
    const auto study = [&](const std::string& entries) {
        return read_study(
            folder_.write("study.toml",
                          "[grains]\ndiameter = \"500 um\"\ndensity = \"2500 "
                          "kg/m^3\"\n[cell]\ninner_radius = \"21 mm\"\nouter_radius = "
                          "\"45 mm\"\nbead_mass = \"46 g\"\n" +
                              entries));
    };
    const std::string entry = "[[recording]]\nfile = \"book.xlsx\"\n";
    const Study two = study(entry + "sheet = \"3 kPa\"\n" + entry + "sheet = \"6*\"\n");
    ASSERT_EQ(two.sources.size(), 2u);
    ASSERT_EQ(two.sources[1].files.size(), 1u);
    EXPECT_DOUBLE_EQ(read_recording(two.sources[0].files[0], two.sources[0].format).torque[0],
                     0.02);
    EXPECT_DOUBLE_EQ(read_recording(two.sources[1].files[0], two.sources[1].format).torque[0],
                     0.04);
    EXPECT_THAT(unread_sheets(two)[0].names, ElementsAre("Cover"));
    EXPECT_THAT(study(entry).sources[0].files, SizeIs(2));
    expect_told({input_error([&] { study(entry + entry + "sheet = \"6 kPa\"\n"); }),
                 input_error([&] { study(entry + "sheet = \"9 kPa\"\n"); })});
}

TEST_F(Workbook, MayHaveATitleAboveItsTable) {
    const auto book =
        of_table("Versuch 7\nInner radius: 21 mm\n\n" + header + rows_of({"0", "1", "2"}));
    EXPECT_EQ(read_recording(book).time, (std::vector<double>{0, 1, 2}));
    EXPECT_EQ(read_recording(book).line, (std::vector<int>{5, 6, 7}));
    EXPECT_EQ(read_blocks(book).fact("inner radius"), "21 mm");
}

TEST_F(Workbook, HasClockTimesInSeconds) {
    // A day has 86400 s, so that 0.25 is 6 h; [h]:mm:ss counts on beyond a day.
    const auto book =
        of_table(header + rows_of({"clock:0.25", "clock:0.25005787037037", "clock:1.25"}));
    EXPECT_THAT(read_recording(book).time,
                ElementsAre(0, testing::DoubleNear(5, 1e-6), testing::DoubleNear(86400, 1e-6)));
    EXPECT_EQ(read_blocks(book).blocks[0].columns[0].unit, "h:min:s");
    const auto dates = of_table(header + rows_of({"date:45352.999988425926", "date:45353"}));
    EXPECT_THAT(read_recording(dates).time, ElementsAre(0, testing::DoubleNear(1, 1e-6)));
}

TEST_F(Workbook, CountsDatesFrom1900Or1904) {
    const auto table =
        folder_.write("d.csv", "Date,Torque [N m]\ndate:45352,1\ndate:59,2\ndate:61,3\n");
    const auto dates = [&](const std::string& option) {
        std::vector<std::string> result;
        const BlockFile file = read_blocks(workbook(option + "D=" + table.string()));
        for (const Row& row : file.blocks[0].table.rows)
            result.push_back(row.cells[0].text);
        return result;
    };
    // Day 60 of the calendar from 1900 is 29 February 1900, which never was.
    EXPECT_THAT(dates(""),
                ElementsAre("2024-03-01 00:00:00", "1900-02-28 00:00:00", "1900-03-01 00:00:00"));
    EXPECT_THAT(dates("--1904 "),
                ElementsAre("2028-03-02 00:00:00", "1904-02-29 00:00:00", "1904-03-02 00:00:00"));
}

TEST(CellFormats, TellDatesFromNumbers) {
    for (const char* code :
         {"0.00", "General", "0.00E+00", "0.0\" days\"", "[Red]0.0", "0\\ \\h", "@", "#,##0"})
        EXPECT_FALSE(format_of_code(code).date || format_of_code(code).time) << code;
    for (const char* code : {"d. mmm", "yyyy-mm-dd", "mmm-yy", "[$-407]dd.mm.yyyy"})
        EXPECT_TRUE(format_of_code(code).date && !format_of_code(code).time) << code;
    for (const char* code : {"[h]:mm:ss", "mm:ss.0", "h:mm AM/PM"})
        EXPECT_TRUE(!format_of_code(code).date && format_of_code(code).time) << code;
    EXPECT_TRUE(format_of_code("d/m/yy h:mm").date && format_of_code("d/m/yy h:mm").time);
}

TEST_F(Workbook, HoldsANumberInEachRowOfAMergedCell) {
    const auto book =
        of_table("Interval,Time [s],Torque [N m]\n7,0,1\n,1,2\n8,0,3\n!merge A2:A3\n");
    const BlockFile file = read_blocks(book);
    EXPECT_EQ(file.blocks[0].table.rows[1].cells[0].text, "7");
    EXPECT_EQ(file.blocks[0].table.rows[2].cells[0].text, "8");
    const auto wide = of_table("Time [s],Torque [N m],Gap [mm]\n0,1,2\n1,2,\n!merge B3:C3\n");
    expect_told({input_error([&] { read_blocks(wide); })});
    // Where nothing is read, as in remarks or in the lines above the table, it does no harm.
    const auto beside =
        of_table("Time [s],Torque [N m],Remark,More\n0,1,2,\n1,2,3,\n!merge C3:D3\n");
    EXPECT_EQ(read_blocks(beside).blocks[0].table.rows.size(), 2u);
}

TEST_F(Workbook, ReadsHiddenRowsAndSaysSo) {
    const FileView view = view_of_file(of_table(header + rows_of({"0", "1", "2"}) + "!hide 3\n"));
    EXPECT_THAT(view.series[0].time, ElementsAre(0, 1, 2));
    ASSERT_THAT(view.findings, SizeIs(1));
    EXPECT_EQ(view.findings[0].kind, Remark::Kind::hidden_rows);
    EXPECT_THAT(view.findings[0].lines, ElementsAre(Lines{3, 3, 0}));
    expect_told({with_lines(view.findings[0])});
}

TEST_F(Workbook, NamesTheRowOfAWrongCell) {
    const auto book = of_table(
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s]\n1,2,3,4,5\n"
        "2,x,3,4,5\n");
    expect_told({input_error([&] { read_recording(book); })});
}

TEST_F(Workbook, RefusesACellWithoutANumberByItsName) {
    // An error, a formula that no program has computed, and a number that became a date.
    for (const std::string cell : {"#DIV/0!", "=B2*2", "date:45323"})
        expect_told({input_error(
            [&] { read_recording(of_table(header + rows_of({"0"}) + rows_of({"1"}, cell))); })});
    const BlockFile unused = read_blocks(of_table("Torque [N m],Remark\n1,#DIV/0!\n2,=A1\n"));
    EXPECT_EQ(unused.blocks[0].table.rows.size(), 2u);
}

TEST_F(Workbook, KeepsQuotesAndBlankRows) {
    const auto book = of_table("Torque [N m],\"\"\"G\"\"\"\n1,2\n,\n3,4\n");
    const BlockFile file = read_blocks(book);
    EXPECT_EQ(file.blocks[0].table.header.cells[1].text, "\"G\"");
    ASSERT_EQ(file.blocks[0].table.rows.size(), 2u);
    EXPECT_EQ(file.blocks[0].table.rows[1].line, 4);
}

TEST_F(Workbook, HasNoMoreSheetsThanCanBeRead) {
    const std::string table = folder_.write("t.csv", "Torque [N m],x\n1,2\n").string();
    std::string sheets;
    for (int k = 0; k <= 1000; ++k)
        sheets += " S" + std::to_string(k) + "=" + table;
    const auto book = workbook(sheets);
    expect_told({input_error([&] { chosen_sheets(book, ""); })});
}

TEST_F(Workbook, IsRefusedIfItIsNone) {
    const auto book = of_table("Torque [N m],x\n1,2\n");
    const std::string bytes = read_bytes(book, largest_table);
    const auto damaged = folder_.write("damaged.xlsx", bytes.substr(0, bytes.size() / 2));
    expect_told({input_error([&] { read_blocks(damaged); }),
                 input_error([&] { read_blocks(folder_.write("d.xls", "\xD0\xCF\x11\xE0")); })});
}

}  // namespace pendular::data_workbook_test
