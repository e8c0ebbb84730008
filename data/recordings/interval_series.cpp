#include "data/recordings/interval_series.h"

#include <limits>
#include <utility>

#include "data/files/columns.h"

namespace pendular {
namespace {

using Member = std::vector<double> IntervalSeries::*;

const std::vector<std::pair<std::string_view, Member>>& series_members() {
    static const std::vector<std::pair<std::string_view, Member>> members = {
        {"time", &IntervalSeries::time},
        {"torque", &IntervalSeries::torque},
        {"normal_force", &IntervalSeries::normal_force},
        {"height", &IntervalSeries::height},
        {"angular_velocity", &IntervalSeries::angular_velocity},
        {"shear_stress", &IntervalSeries::shear_stress},
        {"normal_stress", &IntervalSeries::normal_stress},
        {"shear_rate", &IntervalSeries::shear_rate}};
    return members;
}

}  // namespace

const std::vector<std::string_view>& series_quantities() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const auto& [name, member] : series_members())
            all.push_back(name);
        return all;
    }();
    return names;
}

const std::vector<double>& IntervalSeries::column(std::string_view quantity) const {
    static const std::vector<double> none;
    for (const auto& [name, member] : series_members())
        if (name == quantity) return this->*member;
    return none;
}

IntervalSeries series_of(const Block& block) {
    IntervalSeries series;
    const Columns columns(block.table);
    for (const Row& row : block.table.rows)
        series.line.push_back(row.line);
    for (const auto& [name, member] : series_members()) {
        if (!columns.has(name)) continue;
        constexpr double none = std::numeric_limits<double>::quiet_NaN();
        for (const Row& row : block.table.rows)
            (series.*member).push_back(columns.value_if_any(row, name).value_or(none));
    }
    return series;
}

}  // namespace pendular
