#include "calib/fit/reading_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "data/recordings/reading_groups.h"

namespace pendular {

std::size_t dry_count(const std::vector<Reading>& readings) {
    return static_cast<std::size_t>(
        std::ranges::count_if(readings, [](const Reading& r) { return r.condition.dry(); }));
}

std::vector<Reading> part(const std::vector<Reading>& readings, std::size_t from, std::size_t to) {
    return {readings.begin() + static_cast<std::ptrdiff_t>(from),
            readings.begin() + static_cast<std::ptrdiff_t>(to)};
}

std::vector<Reading> dry_first(const Measurements& measurements) {
    auto readings = measurements.readings;
    std::stable_partition(readings.begin(), readings.end(),
                          [](const Reading& r) { return r.condition.dry(); });
    return readings;
}

std::vector<Reading> readings_to_fit(const Measurements& measurements) {
    return binned_readings(dry_first(measurements), most_fitted);
}

std::optional<std::string> note_on_means(std::size_t used, std::size_t measured) {
    if (used >= measured) return {};
    return fmt::format(
        "Fits and tests use the means of {} bins of neighbouring conditions in place of the {} "
        "readings.",
        used, measured);
}

namespace {

/// Relative tolerance of the liquid contents of one group [1]: that of replicates' normal stresses.
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
