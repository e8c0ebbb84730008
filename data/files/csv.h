#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "data/input_error.h"

namespace pendular {

/// Cell of a table without the blanks and quotes around it.
struct Cell {
    std::string text;
    int column = 0;  ///< in characters from the start of the line, from 1
};

/// Line of a table.
struct Row {
    int line = 0;
    std::vector<Cell> cells;
};

/// A table of text cells: a header and at least one row, each row as long as the header.
struct Table {
    std::string file;
    Row header;
    std::vector<Row> rows;
    char delimiter = ',';

    Position at(const Row& row, std::size_t cell) const {
        return {file, row.line, row.cells[cell].column};
    }
    Position at_header(std::size_t cell) const { return at(header, cell); }
};

/// Reads a delimited text file. The delimiter is found in the header among comma, semicolon and
/// tab; blank lines, lines of empty cells and lines that begin with '#' are passed over.
/// @throws InputError at file:line:column for an empty file, no data rows, rows of another length
///         than the header, quotes that do not close, and column names that stand twice
Table read_table(const std::filesystem::path& path);

/// Text quoted as one cell of a CSV file; line ends become blanks.
std::string csv_cell(std::string_view text);

}  // namespace pendular
