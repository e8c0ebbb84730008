#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "data/files/old_workbook.h"
#include "data/files/sheet_rows.h"

namespace pendular {

/// Whether bytes are the beginning of a workbook: of a ZIP archive (.xlsx) or, from before 2007, of
/// a compound file (.xls). Four bytes suffice.
bool begins_workbook(std::string_view bytes);

/// Returns the names of the sheets of a workbook (.xlsx or .xls), in its order.
/// @param file path of the workbook, for error messages
/// @throws InputError if the bytes are no workbook, or a sheet has a name that `is_sheet_name`
///         excludes
std::vector<SheetName> sheet_names(const std::string& bytes, const std::string& file);

/// Checks that so many sheets of a workbook can be read one after the other.
/// @throws InputError if that would take minutes
void check_sheet_count(const std::string& bytes, const std::string& file, std::size_t sheets);

/// Calls a function with the name and the rows of each sheet that is not hidden. Together, the
/// sheets may unpack to `largest_unpacked`.
/// @throws InputError as `sheet_names`, `check_sheet_count` and `sheet_text`
void for_each_shown_sheet(
    const std::string& bytes, const std::string& file,
    const std::function<void(const std::string& name, const SheetText&)>& take);

/// Returns a sheet of a workbook as text in UTF-8 (`rows_of_sheet`, `OldWorkbook`).
/// @param file path of the workbook, for error messages
/// @throws InputError if the bytes are no workbook, lack the sheet, unpack to more than
///         `largest_unpacked`, have more than `most_cells` cells, or as `rows_of_sheet`
SheetText sheet_text(const std::string& bytes, const std::string& file, const std::string& sheet);

}  // namespace pendular
