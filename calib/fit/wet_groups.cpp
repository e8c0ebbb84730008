#include "calib/fit/wet_groups.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace pendular {
namespace {

/// Relative tolerance of the liquid contents of one group [1].
constexpr double liquid_content_tolerance = 0.02;

bool alike(const Condition& a, const Condition& b) {
    return a.at_failure == b.at_failure &&
           agree(a.liquid_content, b.liquid_content, liquid_content_tolerance) &&
           agree(a.inertial_number, b.inertial_number, inertial_number_tolerance);
}

}  // namespace

bool agree(double a, double b, double tolerance) {
    return std::abs(a - b) <= tolerance * std::max(std::abs(a), std::abs(b));
}

std::vector<WetGroup> wet_groups(const std::vector<Reading>& readings) {
    std::vector<WetGroup> groups;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        const Condition& own = readings[k].condition;
        if (own.dry()) {
            continue;
        }
        // Each reading joins the first group with whose first reading it agrees.
        const auto home = std::ranges::find_if(groups, [&](const WetGroup& group) {
            return alike(readings[group.members.front()].condition, own);
        });
        (home == groups.end() ? groups.emplace_back() : *home).members.push_back(k);
    }
    for (WetGroup& group : groups) {
        group.at_failure = readings[group.members.front()].condition.at_failure;
        for (const std::size_t k : group.members) {
            group.liquid_content += readings[k].condition.liquid_content;
            group.inertial_number += readings[k].condition.inertial_number;
        }
        const auto count = static_cast<double>(group.members.size());
        group.liquid_content /= count, group.inertial_number /= count;
    }
    std::ranges::sort(groups, {}, [](const WetGroup& g) {
        return std::tuple(g.liquid_content, g.inertial_number, g.at_failure);
    });
    return groups;
}

}  // namespace pendular
