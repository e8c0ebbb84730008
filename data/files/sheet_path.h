#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace pendular {

/// A sheet of a workbook is a file of measurements like any other, with the path
/// "runs.xlsx [6 kPa]". Everything that tells files apart by their paths (replicates, remarks,
/// figures) so tells sheets apart; only who opens the file asks for its parts. Spreadsheets allow
/// neither brackets nor slashes in the name of a sheet.
struct SheetPath {
    std::filesystem::path book;
    std::string sheet;
};

/// Returns the path of a sheet.
std::filesystem::path path_of_sheet(const std::filesystem::path& book, std::string_view sheet);

/// Returns the parts of the path of a sheet; empty for other paths, such as that of a file whose
/// own name ends with brackets.
std::optional<SheetPath> as_sheet(const std::filesystem::path& path);

/// Returns the file in which a path's measurements are: the workbook for a sheet.
std::filesystem::path file_to_open(const std::filesystem::path& path);

/// Whether a sheet may be named so that `as_sheet` gives the name back.
bool is_sheet_name(std::string_view name);

/// Returns the name of a cell of a sheet: "B7" for column 2 of row 7, both from 1.
std::string cell_name(int row, int column);

}  // namespace pendular
