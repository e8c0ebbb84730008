#include "workflow/tidy_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "data/quantities/quantity.h"

namespace pendular {
namespace {

/// Names of the quantities of which any interval has a column.
std::vector<std::string_view> quantities_of(const FileView& view) {
    std::vector<std::string_view> names;
    for (const auto& [name, values] : series_columns())
        if (std::ranges::any_of(view.series, [column = values](const IntervalSeries& each) {
                return !(each.*column).empty();
            }))
            names.push_back(name);
    return names;
}

}  // namespace

std::string tidy_table(const FileView& view) {
    const std::vector<std::string_view> names = quantities_of(view);
    std::string text = tidy_table_begin, units = ",1,,1";
    for (const std::string_view name : names) {
        text += fmt::format(",{}", name);
        units += fmt::format(",{}", quantity(name).unit);
    }
    text += "\n" + units + "\n";
    for (std::size_t k = 0; k < view.series.size(); ++k) {
        const IntervalSeries& series = view.series[k];
        const std::string begin = fmt::format("{},{},{}", csv_text_cell(view.file.blocks[k].test),
                                              view.file.blocks[k].number, view.roles[k].role);
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
    return text;
}

}  // namespace pendular
