#include "data/recordings/test_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "data/recordings/step_series.h"

namespace pendular {

std::optional<std::string> load_ramp(const IntervalSeries& series) {
    const auto ramp = speed_ramp(series.normal());
    if (!ramp) return std::nullopt;
    return fmt::format("load ramp: the normal {} changes {}",
                       series.normal_stress.empty() ? "force" : "stress", ramp->change());
}

bool has_column_of_readings(const Block& block) {
    constexpr std::array<std::string_view, 6> names = {"shear_velocity", "shear_rate",
                                                       "height",         "solid_fraction",
                                                       "bulk_density",   "inertial_number"};
    return std::ranges::any_of(block.columns, [&](const BlockColumn& column) {
        return std::ranges::find(names, column.quantity) != names.end();
    });
}

bool is_table_of_points(const Block& block, const IntervalSeries& series) {
    constexpr std::size_t most_points = 1000, fewest_points = 3;
    // Two thirds of the least step between set points that steps.cpp tells apart.
    constexpr double jump = 0.05;
    const bool stresses = !series.shear_stress.empty() && !series.normal_stress.empty();
    if (!stresses || !series.time.empty() || !series.angular_velocity.empty() ||
        !series.interval.empty() || has_column_of_readings(block) || block.declared_rows ||
        series.size() < fewest_points || series.size() > most_points)
        return false;
    std::size_t jumps = 0;
    for (std::size_t i = 1; i < series.size(); ++i) {
        const double before = series.normal_stress[i - 1], now = series.normal_stress[i];
        jumps += std::abs(now - before) > jump * std::max(std::abs(now), std::abs(before));
    }
    return jumps >= 2 && 4 * jumps >= series.size();
}

}  // namespace pendular
