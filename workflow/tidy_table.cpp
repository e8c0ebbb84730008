#include "workflow/tidy_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "data/files/csv.h"
#include "data/files/formats/layouts.h"
#include "data/files/sheet_path.h"
#include "data/quantities/quantity.h"

namespace pendular {
namespace {

/// Value that an interval states of its preshear, with the name of its quantity.
struct Stated {
    std::string_view name;
    std::optional<double> Block::*value;
};

const std::vector<Stated>& stated_values() {
    static const std::vector<Stated> all = {
        {"preshear_stress", &Block::preshear_normal_stress},
        {"preshear_shear_stress", &Block::preshear_shear_stress},
        {"bulk_density", &Block::bulk_density}};
    return all;
}

/// Values that any interval of the views states.
std::vector<Stated> stated_in(const std::vector<FileView>& views) {
    std::vector<Stated> result;
    for (const Stated& each : stated_values()) {
        const auto states = [&](const Block& block) { return (block.*each.value).has_value(); };
        if (std::ranges::any_of(views, [&](const FileView& view) {
                return std::ranges::any_of(view.file.blocks, states);
            }))
            result.push_back(each);
    }
    return result;
}

std::string cell_of(const std::optional<double>& value) {
    if (!value || !std::isfinite(*value)) return ",";
    // Seconds since 1970 have as many digits before the point as other values in all.
    constexpr double many_digits = 1e7;
    return std::abs(*value) < many_digits ? fmt::format(",{:.10g}", *value)
                                          : fmt::format(",{:.15g}", *value);
}

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
/// @param end cells after those of the quantities
void add_rows(const IntervalSeries& series, const std::string& begin,
              const std::vector<std::string_view>& names, const std::string& end,
              std::string& text) {
    for (std::size_t i = 0; i < series.size(); ++i) {
        text += fmt::format("{},{}", begin, series.line[i]);
        for (const std::string_view name : names) {
            const auto& column = series.column(name);
            text += cell_of(i < column.size() ? std::optional(column[i]) : std::nullopt);
        }
        text += end + "\n";
    }
}

}  // namespace

std::string tidy_table(const std::vector<FileView>& views) {
    const std::vector<std::string_view> names = quantities_of(views);
    const std::vector<Stated> stated = stated_in(views);
    std::string text = tidy_table_begin, units = ",1,,1";
    for (const std::string_view name : names) {
        text += fmt::format(",{}", name);
        units += fmt::format(",{}", quantity(name).unit);
    }
    for (const Stated& each : stated) {
        text += fmt::format(",{}", each.name);
        units += fmt::format(",{}", quantity(each.name).unit);
    }
    text += "\n" + units + "\n";
    for (const FileView& view : views) {
        for (std::size_t k = 0; k < view.series.size(); ++k) {
            const std::string begin =
                fmt::format("{},{},{}", csv_text_cell(test_in_table(view, k, views.size() > 1)),
                            view.file.blocks[k].number, view.roles[k].role);
            std::string end;
            for (const Stated& each : stated)
                end += cell_of(view.file.blocks[k].*each.value);
            add_rows(view.series[k], begin, names, end, text);
        }
    }
    return text;
}

}  // namespace pendular
