#pragma once

#include <string>
#include <vector>

#include "data/files/formats/block_file.h"
#include "data/files/formats/file_format.h"

namespace pendular {

/// Index, from 0, of the first line from `from` on that has more than blanks and delimiters; the
/// number of lines if there is none.
std::size_t first_filled_line(const SourceLines& source, std::size_t from);

/// Names and units of the columns of a table.
struct NamesAndUnits {
    std::vector<std::string> names, units;
};

/// Names and units of the columns that the user states (`FileFormat::columns`).
NamesAndUnits stated_columns(const FileFormat& format);

/// Reads intervals that are stacked in one table. A row of two whole numbers states number and
/// points of the interval that follows; a point counter in the first column that restarts begins an
/// interval too.
/// @param begin line, from 0, of the first row
void read_stacked_rows(const SourceLines& source, std::size_t begin, const Row& header,
                       const NamesAndUnits& columns, BlockFile& file);

/// Whether all cells of a row are numbers.
bool all_numbers(const Row& row);

/// First line of a file as a row; sets the delimiter of the file. Empty for a blank file.
Row headerless_first_row(const SourceLines& source, char& delimiter);

/// Header of the columns that the user states, at a line.
Row stated_header(const FileFormat& format, int line);

}  // namespace pendular
