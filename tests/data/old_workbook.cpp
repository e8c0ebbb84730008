// Workbooks from before 2007 (.xls); make_old_workbooks.py wrote those that are read here.
#include "data/files/old_workbook.h"

#include "data/files/compound_file.h"
#include "data/files/file_access.h"
#include "data/files/formats/layouts.h"
#include "data/files/formats/sheets.h"
#include "data/files/workbook.h"
#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::old_workbook_test {

using testing::ElementsAre;
using testing::SizeIs;

const std::string folder = PENDULAR_SOURCE_DIR "/tests/data/old_workbooks/";

/// Texts of the cells of a column.
std::vector<std::string> column_of(const BlockFile& file, std::size_t column) {
    std::vector<std::string> texts;
    for (const Row& row : file.blocks.at(0).table.rows)
        texts.push_back(row.cells.at(column).text);
    return texts;
}

TEST(OldWorkbook, HasItsSheets) {
    const ChosenSheets chosen = chosen_sheets(folder + "three_sheets.xls", "");
    EXPECT_THAT(chosen.read, ElementsAre(folder + "three_sheets.xls [3 kPa]",
                                         folder + "three_sheets.xls [6 kPa]"));
    EXPECT_THAT(chosen.others, ElementsAre("Deckblatt", "verborgen"));
    EXPECT_THAT(chosen_sheets(folder + "three_sheets.xls", "verborgen").read, SizeIs(1));
    FileFormat format;
    format.sheet = "9 kPa";
    expect_told({input_error([&] { read_blocks(folder + "three_sheets.xls", format); })});
}

TEST(OldWorkbook, GivesNumbersWithAllTheirDigits) {
    const Recording recording = read_recording(folder + "three_sheets.xls [6 kPa]");
    EXPECT_THAT(recording.time, ElementsAre(0, 1, 2, 3, 4));
    EXPECT_EQ(recording.line, (std::vector<int>{2, 3, 4, 5, 6}));
    for (int k = 0; k < 5; ++k)
        EXPECT_DOUBLE_EQ(recording.torque[static_cast<std::size_t>(k)],
                         (1e-7 / 3 + (k + 1) / 1000.0) * 1e-3);
    EXPECT_DOUBLE_EQ(recording.height[0], 6.25e-3);
}

TEST(OldWorkbook, GivesResultsOfFormulas) {
    const BlockFile file = read_blocks(folder + "results.xls");
    EXPECT_EQ(file.file, folder + "results.xls [Ω β]");
    EXPECT_THAT(column_of(file, 1),
                ElementsAre("0.1", "0.3333333333333333", "1e+300", "-2.5e-09", "12345678", ""));
    EXPECT_THAT(column_of(file, 2),
                ElementsAre("größer: µ", "#DIV/0!", "TRUE", "#N/A", "FALSE", ""));
}

TEST(OldWorkbook, RefusesCellsWithoutANumberByTheirNames) {
    for (const char* const name : {"error.xls", "not_computed.xls"})
        expect_told({input_error([&] { view_of_file(folder + name); })});
}

TEST(OldWorkbook, TellsDatesByTheirFormats) {
    const BlockFile from_1900 = read_blocks(folder + "dates_1900.xls"),
                    from_1904 = read_blocks(folder + "dates_1904.xls");
    EXPECT_THAT(column_of(from_1900, 0),
                ElementsAre("2024-03-01 00:00:00", "1900-02-28 00:00:00", "1900-03-01 00:00:00"));
    EXPECT_THAT(column_of(from_1904, 0),
                ElementsAre("2028-03-02 00:00:00", "1904-02-29 00:00:00", "1904-03-02 00:00:00"));
    EXPECT_THAT(series_of(from_1900.blocks[0]).time,
                ElementsAre(0, testing::DoubleNear(5.25, 1e-6), testing::DoubleNear(86400, 1e-6)));
}

TEST(OldWorkbook, HoldsMergedCellsAndTellsHiddenRows) {
    const FileView view = view_of_file(folder + "merged_and_hidden.xls");
    ASSERT_THAT(view.series, SizeIs(2));  // intervals 7, merged over two rows, and 8
    EXPECT_THAT(view.series[0].time, ElementsAre(1, 2));
    ASSERT_THAT(view.file.hidden, SizeIs(1));
    EXPECT_EQ(view.file.hidden[0], (Lines{4, 4, 0}));
}

TEST(OldWorkbook, JoinsTextsThatContinueInAnotherRecord) {
    const BlockFile file = read_blocks(folder + "long_texts.xls");
    const std::vector<std::string> texts = column_of(file, 1);
    ASSERT_THAT(texts, SizeIs(400));
    for (std::size_t row = 1; row <= texts.size(); ++row) {
        std::string text = (row % 2 ? "µm " : "Ωm ") + std::to_string(row);
        if (row % 90 > 0) text += " ";
        for (std::size_t k = 0; k < row % 90; ++k)
            text += "ä";
        EXPECT_EQ(texts[row - 1], text);
    }
}

TEST(OldWorkbook, IsRefusedIfItIsNone) {
    const TemporaryFolder own;
    const std::string bytes = read_bytes(folder + "three_sheets.xls", largest_table);
    std::string other = bytes;  // a document of another program in the same container
    for (auto at = other.find("W\0o\0r\0k", 0, 7); at != std::string::npos;
         at = other.find("W\0o\0r\0k", at, 7))
        other[at] = 'B';
    const auto refusal = [&](const std::string& name, const std::string& content) {
        return input_error([&] { read_blocks(own.write(name, content)); });
    };
    expect_told({refusal("head.xls", bytes.substr(0, 4)), refusal("cut.xls", bytes.substr(0, 512)),
                 refusal("other.xls", other),
                 refusal("excel4.xls", std::string("\x09\x04\x06\x00\0\0\x10\0", 8))});
}

}  // namespace pendular::old_workbook_test
