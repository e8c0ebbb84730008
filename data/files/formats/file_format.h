#pragma once

#include <map>
#include <string>
#include <vector>

namespace pendular {

/// Settings of the user for reading a file of measurements. A setting that is empty is determined
/// from the content of the file.
struct FileFormat {
    /// Name of the file's layout, one of `layout_names`; empty: determined from the file.
    std::string layout;
    /// Name of the file's character encoding, such as "UTF-8" or "windows-1252"; empty: determined
    /// from the file.
    std::string encoding;
    /// Decimal mark of the file's numbers, "." or ","; empty: determined from the file.
    std::string decimal;
    std::string sheet;  ///< name of the sheet of a workbook; empty: the first sheet of the workbook
    /// Names and units of all columns, each as `name [unit]`, which replace the header of a file
    /// that has no header or no units.
    std::vector<std::string> columns;
    /// Intervals (steps of a rheometer's test) whose role in the test the user states. The key is a
    /// role such as "failure". The value is the list of the numbers or names of the intervals, such
    /// as "4".
    std::map<std::string, std::vector<std::string>> roles;
    /// Whether torques whose decimal mark or thousands mark was lost in the file are corrected by
    /// means of the shear stresses (`repair_torques`). Corrections are reported.
    bool repair = false;
};

}  // namespace pendular
