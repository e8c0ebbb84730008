#include <cmath>

#include "data/quantities/statistics.h"
#include "data/recordings/replicate_table.h"

namespace pendular {
namespace {

/// Smallest scatter of the stress ratio [1] of rows that may be of several conditions: twice what
/// the torque of one filling differs by from that of the next. Chosen: at a smaller scatter, the
/// error of the friction grows little.
constexpr double large_scatter = 0.03;
/// Largest correlation of stress ratio and solid fraction among such rows [1]: the errors of torque
/// and gap are independent or nearly so.
constexpr double opposed = -0.9;
/// Largest probability [1] of such a correlation by chance: once in a thousand studies.
constexpr double by_chance = 1e-3;

/// Sums over the deviations from the means of the conditions.
struct Sums {
    double ratio = 0, fraction = 0, product = 0;
    double freedom = 0;

    double correlation() const { return product / std::sqrt(ratio * fraction); }
};

Sums sums_of(const ReplicateTable& table, const std::vector<Reading>& readings) {
    Sums sums;
    for (const std::vector<std::size_t>& group : table.groups) {
        const bool recorded =
            std::ranges::any_of(group, [&](std::size_t k) { return readings[k].within_run_only; });
        if (group.size() < 2 || recorded) continue;
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        const auto logarithms = [&](std::size_t k) -> Eigen::Vector2d {
            return {std::log(readings[k].value(0) / readings[k].condition.normal_stress),
                    std::log(readings[k].value(1))};
        };
        for (const std::size_t k : group)
            mean += logarithms(k) / static_cast<double>(group.size());
        for (const std::size_t k : group) {
            const Eigen::Vector2d off = logarithms(k) - mean;
            sums.ratio += off(0) * off(0), sums.fraction += off(1) * off(1);
            sums.product += off(0) * off(1);
        }
        sums.freedom += static_cast<double>(group.size()) - 1;
    }
    return sums;
}

}  // namespace

std::optional<Remark> find_mixed_conditions(const ReplicateTable& table,
                                            const std::vector<Reading>& readings) {
    const Sums sums = sums_of(table, readings);
    if (sums.freedom < 2 || !(sums.ratio > 0 && sums.fraction > 0)) return {};
    const double correlation = sums.correlation();
    const double scatter = std::sqrt(sums.ratio / sums.freedom);
    if (scatter < large_scatter || correlation > opposed) return {};
    const double freedom = sums.freedom - 1;
    const double t =
        -correlation * std::sqrt(freedom / std::max(1e-12, 1 - correlation * correlation));
    const double p = students_t_tail(t, freedom);
    if (p > by_chance) return {};
    return Remark{.kind = Remark::Kind::mixed_conditions,
                  .size = correlation,
                  .relative = scatter,
                  .relative_error = std::sqrt(sums.fraction / sums.freedom),
                  .p = p};
}

}  // namespace pendular
