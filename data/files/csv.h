#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "data/input_error.h"

namespace pendular {

/// Cell of a table that was read from a text file.
struct Cell {
    std::string text;  ///< content of the cell, without the blanks and quotes around it
    /// Position of the cell in the line of the file: number of the cell's first character, from 1.
    int column = 0;
};

/// Row of a table that was read from a text file.
struct Row {
    int line = 0;  ///< number of the row's line in the file, from 1
    std::vector<Cell> cells;
};

/// Table of text cells from a file: a header and rows. Each row has one cell for each cell of the
/// header.
struct Table {
    std::string file;
    Row header;
    std::vector<Row> rows;
    char delimiter = ',';

    /// Returns the position in the file (line and column) of the cell with index `cell`, from 0, in
    /// a row of the table.
    Position at(const Row& row, std::size_t cell) const {
        return {file, row.line, row.cells[cell].column};
    }
    /// Returns the position in the file (line and column) of the table's header cell with index
    /// `cell`, from 0.
    Position at_header(std::size_t cell) const { return at(header, cell); }
};

/// Maximum numbers of table cells that are read: `most_cells` cells (rows times columns) from one
/// file, and `most_cells_of_line` cells from one line. Simple recordings, which `quick_recording`
/// reads, may have more than `most_cells` cells.
constexpr std::size_t most_cells = 20'000'000, most_cells_of_line = 2'000'000;

/// Checks that a file does not have more than `most_cells` cells.
/// @param cells number of cells (rows times columns) up to line `line`
/// @throws InputError at line `line` if `cells` exceeds `most_cells`
void check_cell_count(std::size_t cells, const std::string& file, int line);

/// Treatment of a quotation mark inside a table cell, such as the header `G"`. With `refused`, the
/// mark is an error. With `kept`, the mark is part of the text of the cell.
enum class InnerQuotes { refused, kept };

/// Splits a line of a table into cells. A quote at the start of a cell opens a quoted cell, in
/// which two successive quotes stand for one quote. Blanks around a cell are removed.
/// @param at position of the line: file and line number
/// @throws InputError at file:line:column if a quoted cell is not closed, if a quote is inside a
///         cell and `inner` refuses the quote, or if there are more than `most_cells_of_line` cells
Row split_cells(std::string_view line, char delimiter, const Position& at, InnerQuotes inner);

/// Reads a text file of cells that are separated by a delimiter: the most frequent of comma,
/// semicolon and tab in the header. Blank lines, lines of empty cells and lines that begin with '#'
/// are skipped.
/// @throws InputError at file:line:column if the file cannot be read or has no rows, a row differs
///         in length from the header, a quote is misplaced or not closed, the header repeats a
///         name, consists of numbers or has more than 1000 cells, or the table has more than
///         `most_cells` cells
Table read_table(const std::filesystem::path& path);

/// Parses the lines of a text as a table, by the rules of `read_table`, and returns the table.
/// @param file path of the file, for error messages
/// @throws InputError at file:line:column in the cases of `read_table`, except for a file that
///         cannot be read
Table table_of(const std::string& file, const std::vector<std::string_view>& lines);

/// Returns a text as one cell of a CSV file. A text that contains a delimiter (comma, semicolon or
/// tab), a quote or a line end (LF or CR) is put in quotes. Each quote in the text is doubled, and
/// each line end becomes a blank.
std::string csv_cell(std::string_view text);

/// Returns a cell of a CSV file with a text that people made, such as the name of a file. A text
/// that a spreadsheet would take for a formula, since it begins with =, +, -, @, TAB or CR, gets an
/// apostrophe in front, at which spreadsheets show it as text. A number stays as it is.
/// Source: OWASP, CSV Injection.
std::string csv_text_cell(std::string_view text);

}  // namespace pendular
