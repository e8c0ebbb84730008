#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace pendular {

/// Largest total size, unpacked, of the parts of a workbook that are read [bytes]: as
/// `largest_table`, since a small archive may unpack to any size.
constexpr std::uintmax_t largest_unpacked = 256u << 20;

/// Whether bytes are the beginning of a ZIP archive, such as a workbook (.xlsx).
bool is_archive(std::string_view bytes);

/// Returns a sheet of a workbook (.xlsx) as text in UTF-8: one line per row, with cells separated
/// by tabs. Each row with values has as many cells as the widest row, and each row without values
/// is an empty line. Numbers have a decimal point and all digits that the workbook stores. A
/// formula becomes its stored result, an error such as #DIV/0! an empty cell, and tabs and line
/// ends within a cell become blanks.
/// @param file path of the file, for error messages
/// @param sheet empty: the first sheet of the workbook
/// @throws InputError if the bytes are no workbook, lack the sheet, unpack to more than
///         `largest_unpacked`, or have more than `most_cells` cells
/// Source: ECMA-376, Office Open XML File Formats, part 1, section 18 (SpreadsheetML).
std::string sheet_text(const std::string& bytes, const std::string& file, const std::string& sheet);

}  // namespace pendular
