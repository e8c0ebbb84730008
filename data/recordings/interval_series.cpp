#include "data/recordings/interval_series.h"

#include <limits>

#include "data/files/columns.h"

namespace pendular {

std::span<const SeriesColumn> series_columns() {
    static constexpr SeriesColumn columns[] = {
        {"time", &IntervalSeries::time},
        {"torque", &IntervalSeries::torque},
        {"normal_force", &IntervalSeries::normal_force},
        {"height", &IntervalSeries::height},
        {"angular_velocity", &IntervalSeries::angular_velocity},
        {"interval", &IntervalSeries::interval},
        {"shear_stress", &IntervalSeries::shear_stress},
        {"normal_stress", &IntervalSeries::normal_stress},
        {"shear_rate", &IntervalSeries::shear_rate},
        {"shear_velocity", &IntervalSeries::shear_velocity},
        {"lever_force", &IntervalSeries::lever_force}};
    return columns;
}

const std::vector<double>& IntervalSeries::column(std::string_view quantity) const {
    static const std::vector<double> none;
    for (const auto& [name, values] : series_columns())
        if (name == quantity) return this->*values;
    return none;
}

IntervalSeries IntervalSeries::rows(std::size_t begin, std::size_t end) const {
    const auto part = [&](const auto& all, auto& result) {
        if (!all.empty())
            result.assign(all.begin() + static_cast<std::ptrdiff_t>(begin),
                          all.begin() + static_cast<std::ptrdiff_t>(end));
    };
    IntervalSeries result;
    part(line, result.line);
    for (const auto& [name, values] : series_columns())
        part(this->*values, result.*values);
    return result;
}

void IntervalSeries::erase_rows(const std::vector<bool>& marked) {
    const auto erase = [&](auto& column) {
        if (column.empty()) return;  // the file has no such column
        std::size_t kept = 0;
        for (std::size_t i = 0; i < marked.size(); ++i)
            if (!marked[i]) column[kept++] = column[i];
        column.resize(kept);
    };
    erase(line);
    for (const auto& [name, values] : series_columns())
        erase(this->*values);
}

IntervalSeries series_of(const Block& block) {
    IntervalSeries series;
    const Columns columns(block.table);
    for (const Row& row : block.table.rows)
        series.line.push_back(row.line);
    for (const auto& [name, values] : series_columns()) {
        if (name == "interval" || !columns.has(name)) continue;
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        for (const Row& row : block.table.rows)
            (series.*values).push_back(columns.value_if_any(row, name).value_or(none));
    }
    if (series.shear_stress.empty() && columns.has("stress_ratio"))
        for (std::size_t i = 0; i < series.normal_stress.size(); ++i)
            series.shear_stress.push_back(series.normal_stress[i] *
                                          columns.value_if_any(block.table.rows[i], "stress_ratio")
                                              .value_or(std::numeric_limits<double>::quiet_NaN()));
    return series;
}

}  // namespace pendular
