#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pendular {

/// Sheets of a workbook that are read, as paths (`SheetPath`), and the names of the others.
struct ChosenSheets {
    std::vector<std::filesystem::path> read;
    std::vector<std::string> others;
};

/// Returns which sheets of a file are read. A file that is no workbook is read itself, as a path of
/// a sheet is.
/// @param wanted name of a sheet, or a pattern such as "* kPa"; empty: every sheet with a table
///        (`holds_table`) or, if there is none, the first one, so that its reader says why. A
///        sheet that the workbook hides is read only by its name or if all are hidden.
/// @throws InputError if the file cannot be read, if no sheet matches `wanted`, or if `wanted` is
///         given for a file that is no workbook
ChosenSheets chosen_sheets(const std::filesystem::path& path, const std::string& wanted);

/// Returns the names of the sheets of a workbook; none for other files.
/// @throws InputError if the file cannot be read
std::vector<std::string> sheets_in(const std::filesystem::path& path);

}  // namespace pendular
