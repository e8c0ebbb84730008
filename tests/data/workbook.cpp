// Workbooks (.xlsx) of the layouts that text files have.
#include "data/files/workbook.h"

#include <cstdlib>

#include "data/files/file_access.h"
#include "data/files/formats/layouts.h"
#include "data/recordings/interval_series.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_workbook_test {

using testing::ElementsAre;

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

TEST_F(Workbook, HasTheSheetThatIsNamed) {
    const auto first = folder_.write("first.csv", "Torque [N m],x\n1,2\n");
    const auto second = folder_.write("second.csv", "Torque [N m],x\n0.001,4\n");
    const auto book = workbook("'One & only'=" + first.string() + " Two=" + second.string());
    EXPECT_EQ(read_blocks(book).blocks[0].table.rows[0].cells[0].text, "1");
    FileFormat format;
    format.sheet = "Two";
    EXPECT_EQ(read_blocks(book, format).blocks[0].table.rows[0].cells[0].text, "0.001");
    format.sheet = "Three";
    expect_told({input_error([&] { read_blocks(book, format); }),
                 input_error([&] { read_blocks(first, format); })});
}

TEST_F(Workbook, NamesTheRowOfAWrongCell) {
    const auto book = of_table(
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s]\n1,2,3,4,5\n"
        "2,x,3,4,5\n");
    expect_told({input_error([&] { read_recording(book); })});
}

TEST_F(Workbook, HasNoValueWhereAFormulaFailed) {
    const auto book = of_table("Torque [N m],Force [N]\n1,2\n#DIV/0!,4\n");
    const BlockFile file = read_blocks(book);
    ASSERT_EQ(file.blocks[0].table.rows.size(), 2u);
    EXPECT_EQ(file.blocks[0].table.rows[1].cells[0].text, "");
    EXPECT_EQ(file.blocks[0].table.rows[1].cells[1].text, "4");
}

TEST_F(Workbook, KeepsQuotesAndBlankRows) {
    const auto book = of_table("Torque [N m],\"\"\"G\"\"\"\n1,2\n,\n3,4\n");
    const BlockFile file = read_blocks(book);
    EXPECT_EQ(file.blocks[0].table.header.cells[1].text, "\"G\"");
    ASSERT_EQ(file.blocks[0].table.rows.size(), 2u);
    EXPECT_EQ(file.blocks[0].table.rows[1].line, 4);
}

TEST_F(Workbook, IsRefusedIfItIsNone) {
    const auto book = of_table("Torque [N m],x\n1,2\n");
    const std::string bytes = read_bytes(book, largest_table);
    const auto damaged = folder_.write("damaged.xlsx", bytes.substr(0, bytes.size() / 2));
    expect_told({input_error([&] { read_blocks(damaged); }),
                 input_error([&] { read_blocks(folder_.write("d.xls", "\xD0\xCF\x11\xE0")); })});
}

}  // namespace pendular::data_workbook_test
