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

/// Column of an interval (step of a rheometer's test): name and unit of the column in the file, and
/// the quantity that the program reads from the column.
struct BlockColumn {
    std::string name;  ///< name of the column in the file, such as "Contrainte de Cisaillement"
    /// Unit of the column in the file, such as "Pa"; empty if the file gives no unit.
    std::string unit;
    /// Name of the quantity that the program reads from the column, such as "shear_stress". The
    /// name is empty if the column is not used.
    std::string quantity;
    /// Name of the quantity whose set points the column contains, such as "normal_force". The name
    /// is empty for a column of measured values.
    std::string set_point_of = {};
};

/// Key and value in the header of a file, such as "Stress constant" and "79577.5 Pa/N.m".
struct Fact {
    std::string key, value;
    int line = 0;  ///< line of the file with the key and the value, from 1
};

/// Rows of a file under one header, such as an interval of a rheometer's test.
struct Block {
    /// Name of the test to which the interval belongs; empty if the file does not name the test.
    std::string test;
    /// Name of the interval, such as "Peak hold - 1"; empty if the file does not name the interval.
    std::string name;
    int number = 0;  ///< number of the interval in its test, from 1; 0: the file gives no number
    /// Role of the interval in the test, such as "failure"; empty if the file does not state the
    /// role.
    std::string stated_role = {};
    /// Bulk density of the sample with its liquid [kg/m^3]; empty if the file does not state the
    /// bulk density.
    std::optional<double> bulk_density = {};
    /// Number of rows that the file declares for the interval; empty if the file declares no
    /// number.
    std::optional<std::size_t> declared_rows;
    std::vector<BlockColumn> columns;
    /// Rows of the interval. Header cells of used columns read `quantity [unit]`. Header cells of
    /// unused columns keep the text of the file, with the number of the column. In the layout
    /// "plain", all header cells keep the text of the file. Numbers have a decimal point.
    Table table;
};

/// Rows of a file that were left out while the file was read, with the reason.
struct SkippedRows {
    int first_line = 0, last_line = 0;
    std::string reason;
    /// Whether the number of rows (points) that the file declares for an interval includes the
    /// skipped rows.
    bool points = true;
};

/// Numbers of intervals (steps of a rheometer's test) and table cells read from a file. The numbers
/// are limited so that reading a small file cannot use much memory.
struct FileCounts {
    std::size_t intervals = 0;
    /// Number of header cells read from the file: sum of the columns of all intervals.
    std::size_t header_cells = 0;
    std::size_t cells = 0;  ///< number of table cells read from the file: rows times columns
};

/// Maximum number of intervals (steps of a rheometer's test) that are read from one file, and
/// maximum number of header cells (intervals times columns) that are read from one file.
constexpr std::size_t most_intervals = 10'000, most_header_cells = 1'000'000;

/// Content of a file of measurements, independent of the layout of the file.
struct BlockFile {
    std::string file;      ///< path of the file of measurements
    std::string layout;    ///< name of the file's layout, one of `layout_names`
    std::string encoding;  ///< name of the file's character encoding
    char delimiter = ',';
    NumberStyle numbers;
    /// Keys, such as "Stress constant", and values in the header of the file; each key once.
    std::vector<Fact> facts;
    std::vector<Block> blocks;  ///< intervals of the file, in the order of the file
    /// Rows of the file that were left out, in the order of reading.
    std::vector<SkippedRows> skipped;
    FileCounts counts;  ///< numbers of intervals and cells that were read from the file so far
    std::set<std::string> known_keys;  ///< keys in the header of the file (`facts`), in lower case

    /// Returns the value of a key in the header of the file. The text is empty if the header lacks
    /// the key. Upper and lower case count as equal.
    std::string fact(std::string_view key) const;

    /// Adds a key of the header with its value, unless the key is already known. Upper and lower
    /// case count as equal.
    void add_fact(Fact fact);
};

/// Lines of a file of measurements. The lines refer to the text of the file without a copy, so that
/// the text must outlive the SourceLines object.
struct SourceLines {
    std::string file;
    std::vector<std::string_view> lines;

    /// Splits a line into cells.
    /// @param line index of the line, from 0
    /// @throws InputError at a quoted cell that is not closed, or if the line has more than
    ///         `most_cells_of_line` cells
    Row row(std::size_t line, char delimiter) const;
};

/// Whether all cells of a table row are empty.
bool is_blank(const Row& row);

/// Returns the delimiter (tab, semicolon or comma) with which most lines from `begin` to `end` - 1
/// have as many cells as the preceding line. At most 1000 lines are examined. If two delimiters are
/// equally consistent, the earlier delimiter in the order tab, semicolon, comma is returned.
char consistent_delimiter(const SourceLines& source, std::size_t begin, std::size_t end);

/// Returns the whole number from 1 to a billion that a cell states, such as the number of an
/// interval. The result is 0 if the cell has any other text.
int count_of(const std::string& cell);

/// Returns the text of a cell with a unit, without the brackets around the unit: "mN·m" for
/// "[mN·m]" or "(mN·m)".
std::string bare_unit(std::string_view cell);

/// Sets the columns and the header of an interval (step of a rheometer's test) from the names and
/// units in the file. If several columns contain one quantity, the column with the most specific
/// name is used ("Time" rather than "Run time"). The first of several equally specific columns is
/// used.
/// @param file file to which the interval belongs; the numbers in `file.counts` are increased
/// @param header row whose cells have the positions of the columns in the file
/// @param details further text on each column, such as "Constant component"; the list may be
///         shorter than the list of columns
/// @throws InputError for more than 1000 columns, `most_intervals` intervals or `most_header_cells`
///         header cells, and for an unknown unit of a known quantity
void set_columns(BlockFile& file, Block& block, Row header, const std::vector<std::string>& names,
                 const std::vector<std::string>& units,
                 const std::vector<std::string>& details = {});

/// Adds a row to an interval (step of a rheometer's test). Missing cells at the end of the row
/// become empty, as do cells such as "---" and "***". A row counts as cut off if it ends before a
/// used column in which the preceding row has a value. The function leaves out a row that is cut
/// off, and lists the row in `file.skipped`.
/// @param file file to which the interval belongs; the number `file.counts.cells` is increased
/// @throws InputError if a cell beyond the last column is not empty, or if the file has more than
///         `most_cells` cells
void add_row(BlockFile& file, Block& block, Row row);

/// Adds a line of a file to `file.skipped`, the list of lines that are left out. If the preceding
/// line was left out for the same reason, the entry of the preceding line is extended by this line.
/// @param reason reason for the user
/// @param points whether the line is one of the points (rows) whose number the file declares
void skip_line(BlockFile& file, int line, const char* reason, bool points = true);

/// Adds an interval (step of a rheometer's test) and its header cells to the counts of a file,
/// `file.counts`, and checks the limits of the counts.
/// @param line line number at which the interval begins
/// @param columns number of columns of the interval
/// @throws InputError for more than `most_intervals` intervals or `most_header_cells` header cells
void count_interval(BlockFile& file, int line, std::size_t columns);

}  // namespace pendular
