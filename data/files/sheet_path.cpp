#include "data/files/sheet_path.h"

#include <fmt/format.h>

#include <system_error>

namespace pendular {

std::filesystem::path path_of_sheet(const std::filesystem::path& book, std::string_view sheet) {
    return fmt::format("{} [{}]", book.string(), sheet);
}

std::optional<SheetPath> as_sheet(const std::filesystem::path& path) {
    const std::string text = path.string();
    const std::size_t bracket = text.rfind(" [");
    if (!text.ends_with(']') || bracket == std::string::npos || bracket == 0) return std::nullopt;
    std::string sheet = text.substr(bracket + 2, text.size() - bracket - 3);
    if (!is_sheet_name(sheet)) return std::nullopt;
    std::error_code error;
    if (std::filesystem::is_regular_file(path, error)) return std::nullopt;  // a file "run [2]"
    return SheetPath{text.substr(0, bracket), std::move(sheet)};
}

std::filesystem::path file_to_open(const std::filesystem::path& path) {
    const auto sheet = as_sheet(path);
    return sheet ? sheet->book : path;
}

bool is_sheet_name(std::string_view name) {
    return !name.empty() && name.find_first_of("[]/") == std::string_view::npos;
}

std::string cell_name(int row, int column) {
    std::string letters;
    for (; column > 0; column = (column - 1) / 26)
        letters.insert(letters.begin(), static_cast<char>('A' + (column - 1) % 26));
    return letters + std::to_string(row);
}

}  // namespace pendular
