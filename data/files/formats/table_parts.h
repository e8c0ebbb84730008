#pragma once

#include <deque>
#include <string>
#include <vector>

#include "data/files/formats/block_file.h"

namespace pendular {

/// One of several tables of a text, with the lines above it.
struct TablePart {
    std::string title;   ///< above the table, such as "4 kPa"; else "table 2"
    SourceLines source;  ///< with all other cells and lines empty, so that positions stay
};

/// Tables of a text that has several.
struct SeveralTables {
    std::vector<TablePart> parts;   ///< none for a text with one table
    std::deque<std::string> texts;  ///< lines that `parts` show
};

}  // namespace pendular
