#include "data/recordings/replicate_groups.h"

#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

/// Largest relative difference of the set points of replicates [1]. Controllers hold a set point to
/// 1 or 2 %.
constexpr double set_point_tolerance = 0.02;

bool close(double a, double b) {
    return std::abs(a - b) <= set_point_tolerance * std::max(std::abs(a), std::abs(b));
}

}  // namespace

bool are_replicates(const Reading& a, const Reading& b) {
    constexpr double rounding = 1e-9;  // of the arithmetic: liquid contents are stated numbers
    const bool same_filling =
        a.condition.bead_volume && b.condition.bead_volume
            ? close(*a.condition.bead_volume, *b.condition.bead_volume)
            : a.condition.bead_volume.has_value() == b.condition.bead_volume.has_value();
    const auto &preshear_a = a.condition.preshear_stress, &preshear_b = b.condition.preshear_stress;
    const bool same_preshear = preshear_a && preshear_b
                                   ? close(*preshear_a, *preshear_b)
                                   : preshear_a.has_value() == preshear_b.has_value();
    return same_filling && same_preshear && a.condition.at_failure == b.condition.at_failure &&
           std::abs(a.condition.liquid_content - b.condition.liquid_content) <= rounding &&
           close(a.condition.normal_stress, b.condition.normal_stress) &&
           close(a.condition.inertial_number, b.condition.inertial_number);
}

std::vector<std::vector<std::size_t>> replicate_groups(const std::vector<Reading>& readings) {
    std::vector<std::vector<std::size_t>> groups;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const auto group = std::ranges::find_if(groups, [&](const auto& members) {
            return are_replicates(readings[members.front()], readings[k]);
        });
        group == groups.end() ? groups.push_back({k}) : group->push_back(k);
    }
    return groups;
}

}  // namespace pendular
