#pragma once

#include <pugixml.hpp>
#include <string>
#include <vector>

#include "data/files/cell_formats.h"
#include "data/files/sheet_lines.h"

namespace pendular {

/// Texts and formats of cells that all sheets of a workbook use.
struct SharedParts {
    std::vector<std::string> strings;
    CellFormats formats;
};

/// Returns the text of a node `si` or `is`: of its child `t`, or of the runs `r`, without phonetic
/// guides.
std::string text_of_item(const pugi::xml_node& item);

/// Returns the rows of a sheet. Numbers have a decimal point and all digits that the workbook
/// stores; dates and times read as in `CellFormats::text_of`. A formula becomes its stored result,
/// "=" and its text where it has none, and an error such as #DIV/0! stays as it is, so that the
/// cell is refused where its number is needed. Merged cells read as in `SheetLines`.
/// @param file path of the sheet, for error messages
/// @throws InputError if the cells of a row are not in order, and if the sheet has more than
///         `most_cells` cells
/// Source: ECMA-376, Office Open XML File Formats, part 1, section 18 (SpreadsheetML).
SheetText rows_of_sheet(const pugi::xml_node& worksheet, const std::string& file,
                        const SharedParts& shared);

}  // namespace pendular
