#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "data/input_error.h"

namespace pendular {

/// Cell of a table that was read from a text file.
struct Cell {
    std::string text;  ///< without the blanks and quotes around it
    /// Number of the cell's first character in its line, from 1; of its column in a sheet.
    int column = 0;
};

/// Row of a table that was read from a text file.
struct Row {
    int line = 0;  ///< line of the file, from 1
    std::vector<Cell> cells;
};

/// Table of text cells from a file. Each row has one cell for each cell of the header.
struct Table {
    std::string file;
    Row header;
    std::vector<Row> rows;
    char delimiter = ',';
    bool of_sheet = false;  ///< whether the table is in a sheet, as `table_of` asked

    /// Returns the position of the cell with index `cell`, from 0, in a row of the table.
    Position at(const Row& row, std::size_t cell) const {
        return {file, row.line, row.cells[cell].column};
    }
    Position at_header(std::size_t cell) const { return at(header, cell); }
};

/// Maximum numbers of cells (rows times columns) that are read from one file, and from one line. A
/// file of 0.9 MB with 150,000 nearly empty rows of 1000 columns took more than 4 GB of memory.
/// Simple recordings, which `quick_recording` reads, may have more than `most_cells`.
constexpr std::size_t most_cells = 20'000'000, most_cells_of_line = 2'000'000;

/// Checks the number of cells of a file up to a line.
/// @throws InputError at the line if `cells` exceeds `most_cells`
void check_cell_count(std::size_t cells, const std::string& file, int line);

/// Treatment of a quotation mark inside a cell, such as the header `G"`: an error, or part of the
/// text.
enum class InnerQuotes { refused, kept };

/// Splits a line of a table into cells. A quote at the start of a cell opens a quoted cell, in
/// which two successive quotes stand for one quote. Blanks around a cell are removed.
/// @param at file and line number
/// @param of_sheet whether the line is one of a sheet, of which columns and not characters are
///        counted; asked once for each table, since the answer is the file system's
/// @throws InputError if a quoted cell is not closed, if a quote is inside a cell and `inner`
///         refuses it, or for more than `most_cells_of_line` cells
Row split_cells(std::string_view line, char delimiter, const Position& at, InnerQuotes inner,
                bool of_sheet = false);

/// Whether a line of a table is no row: blank, a comment that begins with '#', or delimiters alone,
/// as spreadsheets write empty rows.
bool holds_no_row(std::string_view line);

/// Returns a line as a row of a table.
/// @param number of the line, from 1
/// @param last whether it is the last line of the file
/// @throws InputError if the row and the header differ in length, or a quote is misplaced or not
///         closed
Row row_of(const Table& table, std::string_view line, int number, bool last);

/// Reads a text file of cells that are separated by a delimiter: the most frequent of comma,
/// semicolon and tab in the header. Blank lines, lines of empty cells and lines that begin with '#'
/// are skipped.
/// @throws InputError if the file cannot be read or has no rows, a row differs in length from the
///         header, a quote is misplaced or not closed, the header repeats a name, consists of
///         numbers or has more than 1000 cells, or the table has more than `most_cells` cells
Table read_table(const std::filesystem::path& path);

/// Returns the table in the lines of a text, by the rules of `read_table`.
/// @param file path of the file, for error messages
/// @param cut if given, a last row with fewer cells than the header, of a table with at least
///        `fewest_rows_to_cut` others, is left out, and this is its line
/// @throws InputError as `read_table`
Table table_of(const std::string& file, const std::vector<std::string_view>& lines,
               int* cut = nullptr);

/// Rows from which on one that a file ends within may be left out. Chosen: what steady shear is
/// averaged over has more (`shortest_step`), while of few rows, such as points of failure that
/// people type, each counts, and is to be completed.
constexpr std::size_t fewest_rows_to_cut = 10;

/// Returns a text as one cell of a CSV file. A text with a delimiter (comma, semicolon or tab), a
/// quote or a line end is put in quotes; its quotes are doubled and its line ends become blanks.
std::string csv_cell(std::string_view text);

/// Returns a cell of a CSV file with a text that people made, such as the name of a file. A text
/// that a spreadsheet would take for a formula, since it begins with =, +, -, @, TAB or CR, and
/// that is no number gets an apostrophe in front, at which spreadsheets show it as text.
/// Source: OWASP, CSV Injection.
std::string csv_text_cell(std::string_view text);

}  // namespace pendular
