#pragma once

#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Returns the index, from 0, of the first line of a file, at or after the line with index `from`,
/// that contains more than blanks and delimiters. If every line from `from` on is blank, the result
/// is the number of lines.
std::size_t first_filled_line(const SourceLines& source, std::size_t from);

/// Names and units of the columns of a table, one element per column.
struct NamesAndUnits {
    std::vector<std::string> names, units;
};

/// Returns the names and units of the columns in the user's settings (`FileFormat::columns`).
NamesAndUnits stated_columns(const FileFormat& format);

/// Reads intervals (steps of a rheometer's test) that follow each other in one table, and adds the
/// intervals to `file.blocks`. A row of two whole numbers (number of the interval, number of its
/// points) announces an interval. An interval also begins at a row in which a counter of points in
/// the first column restarts.
/// @param begin index of the line of the first row, from 0
/// @param header row whose cells have the positions of the columns in the file
void read_stacked_rows(const SourceLines& source, std::size_t begin, const Row& header,
                       const NamesAndUnits& columns, BlockFile& file);

/// Whether all cells of a row are numbers, with decimal point or decimal comma.
bool all_numbers(const Row& row);

/// Returns the first line, not counting blank lines, of a file without header as a row, and sets
/// `delimiter` to the delimiter of the file. The row has no cells if the file is blank.
Row headerless_first_row(const SourceLines& source, char& delimiter);

/// Returns the header cells in the user's settings (`FileFormat::columns`) as a row.
/// @param line line number that the row gets
Row stated_header(const FileFormat& format, int line);

}  // namespace pendular
