#pragma once

#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Returns the index of the first line, from the index `from` on, that contains more than blanks
/// and delimiters; the number of lines if there is none.
std::size_t first_filled_line(const SourceLines& source, std::size_t from);

/// Names and units of columns, one element per column.
struct NamesAndUnits {
    std::vector<std::string> names, units;
};

/// Returns the names and units in `FileFormat::columns`.
NamesAndUnits stated_columns(const FileFormat& format);

/// Reads intervals that follow each other in one table into `file.blocks`. A row of two whole
/// numbers (number of the interval, number of its points) announces an interval. One also begins
/// where a counter of points in the first column restarts.
/// @param begin index of the line of the first row, from 0
/// @param header row whose cells have the positions of the columns in the file
void read_stacked_rows(const SourceLines& source, std::size_t begin, const Row& header,
                       const NamesAndUnits& columns, BlockFile& file);

/// Whether all cells of a row are numbers, with decimal point or decimal comma.
bool all_numbers(const Row& row);

/// Returns the first line that is not blank of a file without header, and sets `delimiter` to that
/// of the file. The row has no cells if the file is blank.
Row headerless_first_row(const SourceLines& source, char& delimiter);

/// Returns `FileFormat::columns` as a row with a given line number.
Row stated_header(const FileFormat& format, int line);

}  // namespace pendular
