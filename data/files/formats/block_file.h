#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "data/files/csv.h"
#include "data/files/formats/number_style.h"
#include "data/remarks/remark.h"

namespace pendular {

/// Column of an interval, as the file names it and as the program reads it.
struct BlockColumn {
    std::string name;      ///< in the file, such as "Contrainte de Cisaillement"
    std::string unit;      ///< in the file, such as "Pa"; empty: none given
    std::string quantity;  ///< `Quantity::name`, such as "shear_stress"; empty: not used
    /// Quantity whose set points the column contains, such as "normal_force"; empty for measured
    /// values.
    std::string set_point_of = {};
    bool of_errors = false;  ///< whether it has errors of `quantity`, not its values
};

/// Key and value in the header of a file, such as "Stress constant" and "79577.5 Pa/N.m".
struct Fact {
    std::string key, value;
    int line = 0;  ///< of the file, from 1
};

/// Text that stands alone in a line among the rows of a table, such as "Sand B".
struct Title {
    std::string text;
    int line = 0;  ///< of the file, from 1
};

/// Interval of a file: rows under one header, such as a step of a rheometer's test. What the file
/// does not state is empty or 0.
struct Block {
    std::string test;  ///< name of the test to which the interval belongs
    /// Name of the group of a point of failure: that of its test without a liquid content.
    std::string group = {};
    std::string name;                         ///< such as "Peak hold - 1"
    int number = 0;                           ///< of the interval in its test, from 1
    std::string stated_role = {};             ///< one of `interval_roles`
    std::optional<double> bulk_density = {};  ///< of the sample with its liquid [kg/m^3]
    /// Liquid content of a point of failure [1], if the file states it.
    std::optional<double> liquid_content = {};
    /// Normal and shear stress of the preshear of a point of failure [Pa], if the file states them.
    std::optional<double> preshear_normal_stress = {}, preshear_shear_stress = {};
    std::optional<std::size_t> declared_rows;
    std::vector<BlockColumn> columns;
    /// Rows of the interval, with decimal points. Header cells of used columns read `quantity
    /// [unit]`. Those of unused columns keep the text of the file, with the number of the column,
    /// and all in the layout "plain" keep the text of the file.
    Table table;

    /// Whether a column is read as a quantity.
    bool has_column(std::string_view quantity) const {
        return std::ranges::find(columns, quantity, &BlockColumn::quantity) != columns.end();
    }
};

/// Cell whose text states that there is no value, such as "NaN", and that is empty for that.
struct ClearedCell {
    std::size_t row = 0, column = 0;  ///< in the table of its block
    std::string text;
};

/// Intervals and table cells read from a file so far. They are limited so that reading a small file
/// cannot use much memory.
struct FileCounts {
    std::size_t intervals = 0;
    std::size_t header_cells = 0;  ///< sum of the columns of all intervals
    std::size_t cells = 0;         ///< rows times columns
};

/// Maximum numbers of intervals and of header cells that are read from one file. Without them,
/// small files took minutes or all memory (docs/hostile-input.md).
constexpr std::size_t most_intervals = 10'000, most_header_cells = 1'000'000;

/// Content of a file of measurements, independent of the layout of the file.
struct BlockFile {
    std::string file;
    std::string layout;  ///< one of `layout_names`
    std::string encoding;
    char delimiter = ',';
    NumberStyle numbers;
    std::vector<Fact> facts;       ///< each key once; upper and lower case count as equal
    std::vector<Title> titles;     ///< of parts of its tables, in the order of the file
    std::vector<Block> blocks;     ///< in the order of the file
    std::vector<Remark> skipped;   ///< rows that were not read, in the order of reading
    std::vector<Lines> hidden;     ///< rows that a workbook hides; they are read
    bool table_of_points = false;  ///< whether each row is a test of its own, and a block
    /// Evidence that grains were sheared along a wall, such as "its column 'Wall shear stress'";
    /// empty: nothing.
    std::string shown_wall;
    FileCounts counts;
    std::set<std::string> known_keys;  ///< keys of `facts`, in lower case

    /// Returns the value of a key in `facts`; empty if it is missing.
    std::string fact(std::string_view key) const;

    /// Adds a key with its value, unless the key is already known.
    void add_fact(Fact fact);
};

/// Lines of a file of measurements: views of its text, which must outlive them.
struct SourceLines {
    std::string file;
    std::vector<std::string_view> lines;
    bool of_sheet = false;  ///< whether the lines are those of a sheet (`split_cells`)

    /// Splits the line with the index `line`, from 0, into cells.
    /// @throws InputError as `split_cells`
    Row row(std::size_t line, char delimiter) const;
};

/// Whether all cells of a row are empty or blank.
bool is_blank(const Row& row);

/// Returns the number of cells with a text.
std::size_t filled_cells(const Row& row);

/// Returns the delimiter (tab, semicolon or comma; the earlier in this order if two are equally
/// consistent) with which most lines from `begin` to `end` - 1 have as many cells as the preceding
/// line. At most 1000 lines are examined.
char consistent_delimiter(const SourceLines& source, std::size_t begin, std::size_t end);

/// Returns the whole number from 1 to a billion that a cell states; 0 for any other text.
int count_of(const std::string& cell);

/// Returns the unit in a cell without brackets: "mN·m" for "[mN·m]" or "(mN·m)".
std::string bare_unit(std::string_view cell);

/// Sets the columns and the header of an interval from the names and units in the file, and counts
/// it (`count_interval`). If several columns contain one quantity, the column with the most
/// specific name is used ("Time" rather than "Run time"), or the first of equally specific ones.
/// @param header row whose cells have the positions of the columns in the file
/// @param details further text on each column, such as "Constant component"; may be shorter
/// @throws InputError for more than 1000 columns, `most_intervals` intervals or `most_header_cells`
///         header cells
void set_columns(BlockFile& file, Block& block, Row header, const std::vector<std::string>& names,
                 const std::vector<std::string>& units,
                 const std::vector<std::string>& details = {});

/// Adds a row to an interval and counts its cells. Missing cells at the end of the row become
/// empty, as do cells such as "---" and "***". A row that ends before a used column in which the
/// preceding row has a value counts as cut off, and goes to `file.skipped` instead.
/// @throws InputError if a cell beyond the last column is not empty, or if the file has more than
///         `most_cells` cells
void add_row(BlockFile& file, Block& block, Row row);

/// Adds lines that are not read to a list, or to its last entry if that ends with the preceding
/// line and has the same reason.
void leave_out(std::vector<Remark>& list, Remark rows);

/// Adds a line to `file.skipped`.
void skip_line(BlockFile& file, int line, Remark::Kind reason);

/// Adds an interval with its number of columns to `file.counts`.
/// @param line line at which the interval begins
/// @throws InputError for more than `most_intervals` intervals or `most_header_cells` header cells
void count_interval(BlockFile& file, int line, std::size_t columns);

}  // namespace pendular
