#include "workflow/tidy_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "data/files/csv.h"
#include "data/files/formats/layouts.h"
#include "data/files/sheet_path.h"
#include "data/quantities/quantity.h"

namespace pendular {
namespace {

/// Names of the quantities of which any interval has a column.
std::vector<std::string_view> quantities_of(const std::vector<FileView>& views) {
    std::vector<std::string_view> names;
    for (const auto& [name, values] : series_columns()) {
        const auto has = [column = values](const IntervalSeries& each) {
            return !(each.*column).empty();
        };
        if (std::ranges::any_of(
                views, [&](const FileView& view) { return std::ranges::any_of(view.series, has); }))
            names.push_back(name);
    }
    return names;
}

/// Name of the test of an interval, or of its sheet or file where there are several.
std::string test_in_table(const FileView& view, std::size_t interval, bool several) {
    const std::string& test = view.file.blocks[interval].test;
    if (!several) return test;
    const auto sheet = as_sheet(view.file.file);
    const std::string part =
        sheet ? sheet->sheet : std::filesystem::path(view.file.file).filename().string();
    return test.empty() ? part : fmt::format("{}, {}", part, test);
}

/// Rows of an interval in a table of the quantities `names`.
void add_rows(const IntervalSeries& series, const std::string& begin,
              const std::vector<std::string_view>& names, std::string& text) {
    for (std::size_t i = 0; i < series.size(); ++i) {
        text += fmt::format("{},{}", begin, series.line[i]);
        for (const std::string_view name : names) {
            const auto& column = series.column(name);
            const bool known = i < column.size() && std::isfinite(column[i]);
            text += known ? fmt::format(",{:.10g}", column[i]) : ",";
        }
        text += "\n";
    }
}

}  // namespace

std::string tidy_table(const std::vector<FileView>& views) {
    const std::vector<std::string_view> names = quantities_of(views);
    std::string text = tidy_table_begin, units = ",1,,1";
    for (const std::string_view name : names) {
        text += fmt::format(",{}", name);
        units += fmt::format(",{}", quantity(name).unit);
    }
    text += "\n" + units + "\n";
    for (const FileView& view : views) {
        for (std::size_t k = 0; k < view.series.size(); ++k) {
            const std::string begin =
                fmt::format("{},{},{}", csv_text_cell(test_in_table(view, k, views.size() > 1)),
                            view.file.blocks[k].number, view.roles[k].role);
            add_rows(view.series[k], begin, names, text);
        }
    }
    return text;
}

}  // namespace pendular
