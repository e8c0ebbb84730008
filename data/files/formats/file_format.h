#pragma once

#include <map>
#include <string>
#include <vector>

namespace pendular {

/// Settings of the user for reading a file of measurements. A setting that is empty is determined
/// from the content of the file.
struct FileFormat {
    std::string layout;    ///< one of `layout_names`
    std::string encoding;  ///< such as "UTF-8" or "windows-1252"
    std::string decimal;   ///< decimal mark, "." or ","
    std::string sheet;     ///< of a workbook, or a pattern; empty: all sheets with a table
    /// Names and units of all columns, each as `name [unit]`, in place of a header that is missing
    /// or has no units.
    std::vector<std::string> columns;
    /// Columns, by name or as `name [unit]`, to be read as a quantity (`Quantity::name`), beside a
    /// header.
    std::map<std::string, std::string> named_columns;
    /// Values that stand for missing ones, such as "-999".
    std::vector<std::string> missing;
    /// For each role, one of `interval_roles`, the numbers or names of the intervals that have it.
    std::map<std::string, std::vector<std::string>> roles;
    /// Whether torques that lost their decimal or thousands mark are corrected by means of the
    /// shear stresses (`repair_torques`). Corrections are reported.
    bool repair = false;
    /// Whether shear stresses at failure are multiplied by the mean shear stress of the preshears
    /// over that of their own (prorating), to take out how unequally samples were consolidated.
    bool prorate = false;
    /// Whether the file holds grains sheared along a wall, not grains along grains.
    bool wall = false;
};

}  // namespace pendular
