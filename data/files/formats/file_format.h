#pragma once

#include <map>
#include <string>
#include <vector>

namespace pendular {

/// Settings with which a user overrides what the program finds in a file of measurements. Empty
/// settings are found in the file.
struct FileFormat {
    std::string layout;    ///< name of the layout, as `layout_names` lists them
    std::string encoding;  ///< name of the character encoding, such as "UTF-8" or "windows-1252"
    std::string decimal;   ///< decimal mark: "." or ","
    std::string sheet;     ///< name of the sheet of a workbook; empty: the first one
    /// Header cells `name [unit]` of all columns, for a file without a header or without units.
    std::vector<std::string> columns;
    /// Intervals by role: role ("failure"), then numbers or names of intervals ("4").
    std::map<std::string, std::vector<std::string>> roles;
    bool repair = false;  ///< whether damaged rows are repaired and marked instead of left out
};

}  // namespace pendular
