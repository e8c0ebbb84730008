#pragma once

#include <pugixml.hpp>
#include <string>
#include <utility>
#include <vector>

#include "data/files/cell_formats.h"

namespace pendular {

/// Number in a cell that is merged over several columns, so that it is not known where it belongs.
struct WideNumber {
    int line = 0;                           ///< from 1
    int first_column = 0, last_column = 0;  ///< from 1
    std::string text;
};

/// Rows of a sheet of a workbook as text.
struct SheetText {
    /// One line per row, with cells separated by tabs. Each row with values has as many cells as
    /// the widest row, and each row without values is an empty line.
    std::string text;
    /// First and last lines, from 1, of rows with values that the spreadsheet hides.
    std::vector<std::pair<int, int>> hidden;
    std::vector<WideNumber> wide;  ///< in the order of the lines; the first of its cells has it
};

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
/// cell is refused where its number is needed. A number in a merged cell of one column stands in
/// each of its rows. Tabs and line ends within a cell become blanks.
/// @param file path of the sheet, for error messages
/// @throws InputError if the cells of a row are not in order, and if the sheet has more than
///         `most_cells` cells
/// Source: ECMA-376, Office Open XML File Formats, part 1, section 18 (SpreadsheetML).
SheetText rows_of_sheet(const pugi::xml_node& worksheet, const std::string& file,
                        const SharedParts& shared);

}  // namespace pendular
