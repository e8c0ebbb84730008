// Workbooks from before 2007 (.xls) that no spreadsheet writes: their records
// are made here.
#include <sys/resource.h>

#include "data/files/formats/sheets.h"
#include "data/files/old_records.h"
#include "data/files/old_sheet.h"
#include "data/files/old_workbook.h"
#include "data/files/workbook.h"
#include "tests/support/golden.h"

namespace pendular::old_workbook_records_test {

namespace kind = record_kind;
using testing::ElementsAre;

/// Whole number in so many bytes, the lowest first.
std::string little(std::uint64_t value, std::size_t bytes) {
    std::string text;
    for (std::size_t i = 0; i < bytes; ++i)
        text += static_cast<char>(value >> (8 * i));
    return text;
}

std::string record(unsigned kind, const std::string& body) {
    return little(kind, 2) + little(body.size(), 2) + body;
}

/// Text of narrow characters, with its length before it in so many bytes.
std::string text(const std::string& characters, std::size_t length_bytes) {
    return little(characters.size(), length_bytes) + little(0, 1) + characters;
}

constexpr std::uint32_t none = 0xFFFF'FFFF, last_of_chain = 0xFFFF'FFFE;

std::string entry_of_directory(const std::string& name, unsigned kind, std::uint32_t child,
                               std::uint32_t first, std::size_t size) {
    std::string wide;
    for (const char c : name)
        wide += little(static_cast<unsigned char>(c), 2);
    wide.resize(64);
    return wide + little(2 * name.size() + 2, 2) + little(kind, 2) + little(none, 4) +
           little(none, 4) + little(child, 4) + std::string(36, '\0') + little(first, 4) +
           little(size, 8);
}

/// Compound file with one stream: its directory in the first sector, then the
/// stream, and the table of allocation behind it.
std::string compound_file(std::string stream, const std::string& name) {
    constexpr std::size_t sector = 4096;
    const std::size_t size = stream.size(), sectors = 1 + (size + sector - 1) / sector;
    stream.resize((sectors - 1) * sector);
    std::string directory = entry_of_directory("Root Entry", 5, 1, last_of_chain, 0) +
                            entry_of_directory(name, 2, none, 1, size);
    directory.resize(sector);
    std::string table = little(last_of_chain, 4);
    for (std::size_t k = 1; k < sectors; ++k)
        table += little(k + 1 < sectors ? k + 1 : last_of_chain, 4);
    table.resize((table.size() + sector - 1) / sector * sector, '\xFF');
    std::string head("\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", 8);
    head.resize(sector);
    head.replace(30, 2, little(12, 2));
    head.replace(60, 4, little(last_of_chain, 4));
    head.replace(68, 4, little(last_of_chain, 4));
    head.replace(76, 436, std::string(436, '\xFF'));
    for (std::size_t k = 0; k * sector < table.size(); ++k)
        head.replace(76 + 4 * k, 4, little(sectors + k, 4));
    return head + directory + stream + table;
}

/// Sheet in the list of a workbook.
struct Listed {
    std::string name;
    std::size_t begin = 0;  ///< in the records of all sheets
    unsigned state = 0;
};

constexpr unsigned excel_97 = 0x600, excel_95 = 0x500;

/// Workbook of these sheets, with their records and others.
std::string workbook(const std::vector<Listed>& sheets, const std::string& records,
                     const std::string& globals = "", unsigned version = excel_97,
                     const std::string& stream = "Workbook") {
    const std::string begin = record(kind::begin, little(version, 2)), end = record(kind::end, "");
    const auto name_of = [&](const Listed& sheet) {
        return version == excel_97 ? text(sheet.name, 1)
                                   : little(sheet.name.size(), 1) + sheet.name;
    };
    std::size_t place = begin.size() + globals.size() + end.size();
    for (const Listed& sheet : sheets)
        place += 10 + name_of(sheet).size();
    std::string list;
    for (const Listed& sheet : sheets)
        list += record(kind::sheet,
                       little(place + sheet.begin, 4) + little(sheet.state, 2) + name_of(sheet));
    return compound_file(begin + list + globals + end + records, stream);
}

/// Records of a sheet with these cells.
std::string sheet(const std::string& cells) {
    return record(kind::begin, little(excel_97, 2)) + cells + record(kind::end, "");
}

std::string number_cell(std::size_t row, std::uint32_t value) {
    return record(kind::short_number, little(row, 2) + little(0, 4) + little(value << 2 | 2, 4));
}

std::string shared_cell(std::size_t row, std::size_t index) {
    return record(kind::shared_text, little(row, 2) + little(0, 4) + little(index, 4));
}

/// Texts that all sheets share: one of this length.
std::string one_text(std::size_t length) {
    return record(kind::shared_texts, little(0, 8) + text(std::string(length, 'x'), 2));
}

const std::string file = "b.xls";

double peak_of_memory() {  // [bytes]
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

TEST(OldWorkbookRecords, HoldASharedTextOnce) {
    std::string cells;
    for (std::size_t row = 0; row < 30'000; ++row)
        cells += shared_cell(row, 0);
    const std::string bytes = workbook({{"A"}}, sheet(cells), one_text(60'000));
    const double before = peak_of_memory();
    expect_told({input_error([&] { sheet_text(bytes, file, "A"); })});
    EXPECT_LT(peak_of_memory() - before, 2e9);  // 2.9e9 with a copy for each cell
}

TEST(OldWorkbookRecords, OfASheetAreOfNoOther) {
    const std::string inner = sheet(number_cell(1, 7));
    const auto told = [&](std::size_t begin) {
        const std::string bytes =
            workbook({{"A"}, {"B", begin}}, sheet(number_cell(0, 7) + inner + number_cell(2, 8)));
        return input_error([&] { for_each_shown_sheet(bytes, file, [](auto&&...) {}); });
    };
    expect_told({told(0), told(sheet(number_cell(0, 7)).size() - 4)});
}

TEST(OldWorkbookRecords, MayShareATextOverFewSheets) {
    std::string cells, records;
    for (std::size_t row = 0; row < 4000; ++row)
        cells += shared_cell(row, 0);
    std::vector<Listed> sheets;
    for (const char* const name : {"A", "B", "C"}) {
        sheets.push_back({name, records.size()});
        records += sheet(cells);
    }
    const TemporaryFolder own;
    const auto path = own.write(file, workbook(sheets, records, one_text(60'000)));
    expect_told({input_error([&] { chosen_sheets(path, ""); })});
}

TEST(OldWorkbookRecords, NameSheetsWithoutTheTextsOfTheirCells) {
    constexpr std::size_t in_record = 65'535 / 3;
    std::string texts;  // more than are read, each of them empty
    for (std::size_t k = 0; k < 5'000'000 / in_record + 1; ++k)
        texts += record(k == 0 ? kind::shared_texts : kind::continuation,
                        std::string(3 * in_record, '\0'));
    const std::string bytes = workbook({{"A"}, {"B", sheet(number_cell(0, 7)).size()}},
                                       sheet(number_cell(0, 7)) + sheet(shared_cell(0, 0)), texts);
    EXPECT_EQ(sheet_names(bytes, file).size(), 2u);
    EXPECT_EQ(sheet_text(bytes, file, "A").text, "7\n");
    expect_told({input_error([&] { sheet_text(bytes, file, "B"); })});
}

/// Text of a cell of Excel 95 in a code page.
std::string cell_in(unsigned code_page, const std::string& characters) {
    const std::string cell =
        record(kind::text, little(0, 6) + little(characters.size(), 2) + characters);
    return sheet_text(workbook({{"A"}}, sheet(cell), record(kind::code_page, little(code_page, 2)),
                               excel_95, "Book"),
                      file, "A")
        .text;
}

TEST(OldWorkbookRecords, AreInCodePagesOfWindows) {
    EXPECT_EQ(cell_in(874, "\xA1\x85"), "ก…\n");
    EXPECT_EQ(cell_in(720, "\xA1"), "ة\n");
    EXPECT_EQ(cell_in(708, "\xC9"), "ة\n");
    EXPECT_EQ(cell_in(437, "gr\x81n"), "grün\n");
    EXPECT_EQ(cell_in(709, "\xB5m"), "µm\n");  // unknown to ICU: windows-1252
}

TEST(OldWorkbookRecords, MayHaveBytesThatAreNoText) {
    EXPECT_EQ(cell_in(932, "Pa\x83"), "Pa\uFFFD\n");
    EXPECT_EQ(cell_in(1253, "Pa\xD2s"), "Pa\uFFFDs\n");
}

TEST(OldWorkbookRecords, HaveTheStateOfASheetInTwoBits) {
    const std::string one = sheet(number_cell(0, 7));
    const auto names =
        sheet_names(workbook({{"A", 0, 0x04}, {"B", one.size(), 0x05}}, one + one), file);
    EXPECT_FALSE(names.at(0).hidden);
    EXPECT_TRUE(names.at(1).hidden);
}

TEST(OldWorkbookRecords, AreInAStreamOfAnyCase) {
    const std::string bytes = workbook({{"A"}}, sheet(number_cell(0, 7)), "", excel_97, "WORKBOOK");
    EXPECT_EQ(sheet_text(bytes, file, "A").text, "7\n");
}

}  // namespace pendular::old_workbook_records_test
