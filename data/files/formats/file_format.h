#pragma once

#include <map>
#include <string>
#include <vector>

namespace pendular {

/// Settings of the user for reading a file of measurements. An empty setting is determined from the
/// content of the file.
struct FileFormat {
    std::string layout;    ///< name of the layout, one of `layout_names`
    std::string encoding;  ///< name of the character encoding, such as "UTF-8" or "windows-1252"
    std::string decimal;   ///< decimal mark: "." or ","
    std::string sheet;     ///< name of the sheet of a workbook; empty: the first one
    /// Header cells `name [unit]` of all columns, for a file that has no header or no units.
    std::vector<std::string> columns;
    /// Intervals for each role that the user states: from a role such as "failure" to numbers or
    /// names of intervals, such as "4".
    std::map<std::string, std::vector<std::string>> roles;
    /// Whether torques that lost a decimal mark are corrected and reported instead of left out.
    bool repair = false;
};

}  // namespace pendular
