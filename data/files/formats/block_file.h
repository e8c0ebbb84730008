#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "data/files/csv.h"
#include "data/files/formats/number_style.h"

namespace pendular {

/// Column of a block, as the file calls it.
struct BlockColumn {
    std::string name;               ///< "Contrainte de Cisaillement"
    std::string unit;               ///< "Pa"; empty if the file states none
    std::string quantity;           ///< name of the quantity that it is read as; empty: not used
    std::string set_point_of = {};  ///< name of the quantity whose set points it holds; empty: none
};

/// Key and value before the rows of a file, such as "Stress constant" and "79577.5 Pa/N.m".
struct Fact {
    std::string key, value;
    int line = 0;  ///< line of the file, from 1
};

/// Stretch of a file under one header, such as an interval of a rheometer's test.
struct Block {
    std::string test;  ///< test or result that the block belongs to; empty if the file names none
    std::string name;  ///< "Peak hold - 1"; empty if the file names none
    int number = 0;    ///< number of the interval in its test, from 1; 0: the file gives none
    std::string stated_role = {};  ///< role that the file gives the interval; empty if it does not
    /// Bulk density of the sample, with liquid [kg/m^3], if the file states it.
    std::optional<double> bulk_density = {};
    /// Number of rows that the file declares for the block, if it does.
    std::optional<std::size_t> declared_rows;
    std::vector<BlockColumn> columns;
    /// The rows. Header cells read `quantity [unit]`, or the file's text for columns that are not
    /// used; numbers have a decimal point.
    Table table;
};

/// Rows of a file that hold no measured values, with the reason why they were left out.
struct SkippedRows {
    int first_line = 0, last_line = 0;
    std::string reason;
    bool points = true;  ///< whether the rows are among the points that the interval declares
};

/// Numbers by which the content of a file is limited, so that a small file cannot ask for much
/// memory.
struct FileCounts {
    std::size_t intervals = 0;
    std::size_t header_cells = 0;  ///< intervals times columns
    std::size_t cells = 0;         ///< rows times columns
};

/// Largest number of intervals of a file, and of intervals times columns.
constexpr std::size_t most_intervals = 10'000, most_header_cells = 1'000'000;

/// Content of a file of measurements, whatever its layout.
struct BlockFile {
    std::string file;      ///< path
    std::string layout;    ///< name of the layout
    std::string encoding;  ///< name of the character encoding
    char delimiter = ',';
    NumberStyle numbers;
    std::vector<Fact> facts;  ///< each key once
    std::vector<Block> blocks;
    std::vector<SkippedRows> skipped;
    FileCounts counts;                 ///< what was read so far
    std::set<std::string> known_keys;  ///< keys of the facts in lower case

    /// Value of the first fact whose key is `key`, upper and lower case being equal; empty if there
    /// is none.
    std::string fact(std::string_view key) const;

    /// Adds a fact unless its key is known, upper and lower case being equal.
    void add_fact(Fact fact);
};

/// Lines of a file that a layout reads. The lines refer to a text that the caller keeps.
struct SourceLines {
    std::string file;
    std::vector<std::string_view> lines;

    /// Cells of a line, which counts from 0.
    /// @throws InputError at a quoted cell that does not close
    Row row(std::size_t line, char delimiter) const;
};

/// Whether all cells of a row are empty.
bool is_blank(const Row& row);

/// Most consistent delimiter of a range of lines: tab, semicolon or comma, the one that splits most
/// lines into as many cells as the line before; the earlier in this list if several do.
char consistent_delimiter(const SourceLines& source, std::size_t begin, std::size_t end);

/// Whole number from 1 to a billion that a cell states, such as the number of an interval; 0 for
/// any other text.
int count_of(const std::string& cell);

/// Text of a unit cell without brackets: "mN·m" of "[mN·m]" or "(mN·m)".
std::string bare_unit(std::string_view cell);

/// Sets columns and header of a block from the names and units of its columns. Of several columns
/// with one quantity, that with the most specific name is used ("Time" rather than "Run time"), or
/// else the first.
/// @param header row whose cells have the positions of the columns
/// @param file file that the block belongs to, which counts it
/// @param details further words on each column, such as "Constant component"; may be shorter
/// @throws InputError for more than 1000 columns, `most_intervals` or `most_header_cells`, and for
/// a
///         unit that is none
void set_columns(BlockFile& file, Block& block, Row header, const std::vector<std::string>& names,
                 const std::vector<std::string>& units,
                 const std::vector<std::string>& details = {});

/// Adds a row to a block. A row that ends before a column that is read, and that the row before
/// has, is left out. Other cells that are missing at its end are empty; "---" and "***" are empty.
/// @param file file that the block belongs to, which counts the row
/// @throws InputError if the row has more cells than the block has columns, and they are not empty;
///         if the file has more than `most_cells`
void add_row(BlockFile& file, Block& block, Row row);

/// Lists a line of a file as left out, in one range with the lines before it if the reason is
/// equal.
void skip_line(BlockFile& file, int line, const char* reason, bool points = true);

/// Counts an interval of a file.
/// @param line line at which the interval begins
/// @throws InputError for more than `most_intervals` or `most_header_cells`
void count_interval(BlockFile& file, int line, std::size_t columns);

}  // namespace pendular
