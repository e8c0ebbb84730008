#include <algorithm>
#include <cmath>
#include <vector>

#include "data/quantities/statistics.h"
#include "data/recordings/replicate_table.h"

namespace pendular {
namespace {

/// Smallest scatter of the stress ratio [1] of rows that may be of several conditions. Chosen: at a
/// smaller scatter, the error of the friction grows little.
constexpr double large_scatter = 0.03;
/// Largest correlation of stress ratio and solid fraction among such rows [1]: the errors of torque
/// and gap are independent or nearly so.
constexpr double opposed = -0.9;
/// Largest probability [1] of such a correlation by chance. Tables whose fillings scatter by so
/// much are rare, so that this is not the rate in honest studies.
constexpr double by_chance = 1e-2;

/// Mean deviations of the rows that have one place among the rows of their condition: rows of a
/// filling, or of a speed, have one place where a table lists them in one order. They, and not the
/// rows, are independent.
struct RowsOfPlace {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    int rows = 0;
};

std::vector<RowsOfPlace> places_of(const ReplicateTable& table,
                                   const std::vector<Reading>& readings) {
    std::vector<RowsOfPlace> places;
    for (const std::vector<std::size_t>& group : table.groups) {
        const bool recorded =
            std::ranges::any_of(group, [&](std::size_t k) { return readings[k].within_run_only; });
        if (group.size() < 2 || recorded) continue;
        const auto logarithms = [&](std::size_t k) -> Eigen::Vector2d {
            return {std::log(readings[k].stress_ratio()), std::log(readings[k].value(1))};
        };
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (const std::size_t k : group)
            mean += logarithms(k) / static_cast<double>(group.size());
        places.resize(std::max(places.size(), group.size()));
        for (std::size_t place = 0; place < group.size(); ++place) {
            places[place].sum += logarithms(group[place]) - mean;
            ++places[place].rows;
        }
    }
    return places;
}

}  // namespace

std::optional<Remark> find_mixed_conditions(const ReplicateTable& table,
                                            const std::vector<Reading>& readings) {
    const std::vector<RowsOfPlace> places = places_of(table, readings);
    // Deviations from a mean, of which one more degree of freedom goes to the correlation.
    const double freedom = static_cast<double>(places.size()) - 2;
    if (freedom < 1) return {};
    Eigen::Matrix2d squares = Eigen::Matrix2d::Zero();
    for (const RowsOfPlace& place : places) {
        const Eigen::Vector2d mean = place.sum / place.rows;
        squares += mean * mean.transpose() / (freedom + 1);
    }
    if (!(squares(0, 0) > 0 && squares(1, 1) > 0)) return {};
    const double correlation = squares(0, 1) / std::sqrt(squares(0, 0) * squares(1, 1));
    const double scatter = std::sqrt(squares(0, 0));
    if (scatter < large_scatter || correlation > opposed) return {};
    const double t =
        -correlation * std::sqrt(freedom / std::max(1e-12, 1 - correlation * correlation));
    const double p = students_t_tail(t, freedom);
    if (p > by_chance) return {};
    return Remark{.kind = Remark::Kind::mixed_conditions,
                  .size = correlation,
                  .relative = scatter,
                  .relative_error = std::sqrt(squares(1, 1)),
                  .p = p};
}

}  // namespace pendular
