#include "data/files/formats/sheets.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "data/files/file_access.h"
#include "data/files/formats/preamble.h"
#include "data/files/sheet_path.h"
#include "data/files/text_file.h"
#include "data/files/workbook.h"
#include "data/input_error.h"

namespace pendular {
namespace {

/// Whether a file begins as a workbook does. Its first bytes tell, so that long recordings are not
/// read for it.
bool is_workbook(const std::filesystem::path& path) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error)) return false;
    // Files of the kernel state no size, and to read them may never end.
    if (std::filesystem::file_size(path, error) < 4 || error) return false;
    std::string begin(4, '\0');
    std::ifstream file(path, std::ios::binary);
    return file.read(begin.data(), 4) && begins_workbook(begin);
}

/// Names of the sheets that are shown and hold a table.
/// @throws InputError for more text in all than sheets of numbers have in a file of the largest
///         size: those of a short workbook may share one long text, which would take minutes
std::set<std::string> sheets_with_table(const std::string& bytes, const std::string& file) {
    constexpr std::uintmax_t most_text = 2 * largest_unpacked;
    std::set<std::string> names;
    std::uintmax_t size = 0;
    for_each_shown_sheet(bytes, file, [&](const std::string& name, const SheetText& sheet) {
        size += sheet.text.size();
        if (size > most_text)
            refuse_workbook(file, fmt::format("its sheets have more than {} MB of text in all",
                                              most_text >> 20));
        if (holds_table({file, split_lines(sheet.text)})) names.insert(name);
    });
    return names;
}

}  // namespace

std::vector<std::string> sheets_in(const std::filesystem::path& path) {
    if (!is_workbook(path)) return {};
    std::vector<std::string> names;
    for (SheetName& sheet : sheet_names(read_bytes(path, largest_table), path.string()))
        names.push_back(std::move(sheet.name));
    return names;
}

ChosenSheets chosen_sheets(const std::filesystem::path& path, const std::string& wanted) {
    if (!is_workbook(path)) {
        if (!wanted.empty())
            throw InputError({path.string()},
                             "is no workbook (.xlsx, .xls), so that 'sheet' cannot name a "
                             "part of it; leave 'sheet' out");
        return {{path}, {}};
    }
    const std::string bytes = read_bytes(path, largest_table);
    const std::vector<SheetName> sheets = sheet_names(bytes, path.string());
    const std::set<std::string> with_table =
        wanted.empty() ? sheets_with_table(bytes, path.string()) : std::set<std::string>();
    const bool named = std::ranges::find(sheets, wanted, &SheetName::name) != sheets.end();
    std::vector<std::string> names;
    ChosenSheets chosen;
    for (const auto& [name, hidden] : sheets) {
        names.push_back(name);
        const bool read = wanted.empty() ? with_table.contains(name)
                          : named        ? name == wanted
                                         : !hidden && fnmatch(wanted.c_str(), name.c_str(), 0) == 0;
        if (read)
            chosen.read.push_back(path_of_sheet(path, name));
        else
            chosen.others.push_back(name);
    }
    if (chosen.read.empty() && !wanted.empty())
        throw InputError({path.string()}, fmt::format("has no sheet \"{}\"; it has \"{}\"", wanted,
                                                      fmt::join(names, "\", \"")));
    if (chosen.read.empty()) {
        const auto shown = std::ranges::find(sheets, false, &SheetName::hidden);
        const std::string& first = (shown == sheets.end() ? sheets.begin() : shown)->name;
        chosen.read.push_back(path_of_sheet(path, first));
        std::erase(chosen.others, first);
    }
    if (chosen.read.size() > 1) check_sheet_count(bytes, path.string(), chosen.read.size());
    return chosen;
}

}  // namespace pendular
