#include "calib/model/run_design.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <stdexcept>

namespace pendular {
namespace {

/// Relative difference from which two settings count as different [1]. Chosen: above the 2 % of
/// replicates, and small beside the lengths over which the flow changes.
constexpr double apart_enough = 0.05;

/// Distance between two settings: the larger difference of ln P* and of ln(liquid content) [1].
double distance(const WetSetting& a, const WetSetting& b) {
    return std::max(std::abs(std::log(a.inverse_pressure / b.inverse_pressure)),
                    std::abs(std::log(a.liquid_content / b.liquid_content)));
}

/// Distance of a setting to the nearest of the others; infinite if there are none.
double distance_to_all(const WetSetting& setting, const std::vector<WetSetting>& others) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& other : others) {
        nearest = std::min(nearest, distance(setting, other));
    }
    return nearest;
}

/// Settings chosen one after the other, each the farthest from those chosen before, until
/// `most_wet_pairs` are chosen or all others are too close.
std::vector<WetSetting> farthest_first(const std::vector<WetSetting>& all) {
    std::vector<WetSetting> chosen = {all.front()};
    while (chosen.size() < most_wet_pairs) {
        const auto next = std::ranges::max_element(
            all, {}, [&](const WetSetting& s) { return distance_to_all(s, chosen); });
        if (distance_to_all(*next, chosen) < apart_enough) {
            break;
        }
        chosen.push_back(*next);
    }
    return chosen;
}

}  // namespace

std::vector<double> inertial_numbers_for(const std::vector<Condition>& conditions, double lowest) {
    if (conditions.empty()) {
        return {};
    }
    const auto [slow, fast] = std::ranges::minmax(conditions, {}, &Condition::inertial_number);
    const double from = std::max(lowest, slow.inertial_number);
    double to = std::max(from, fast.inertial_number);
    if (extrapolated(conditions, lowest)) {
        to = std::max(to, lowest * 10 / 3);
    }
    if (to < 1.05 * from) {
        return {std::sqrt(from * to)};
    }
    const int gaps =
        std::max(1, static_cast<int>(std::ceil(std::log(to / from) / std::log(10.0 / 3) - 1e-6)));
    std::vector<double> levels;
    for (int k = 0; k <= gaps; ++k) {
        levels.push_back(from * std::pow(to / from, static_cast<double>(k) / gaps));
    }
    return levels;
}

bool extrapolated(const std::vector<Condition>& conditions, double lowest) {
    return std::ranges::any_of(conditions, [&](const Condition& condition) {
        return condition.inertial_number < (1 - apart_enough) * lowest;
    });
}

std::vector<WetSetting> wet_settings_for(const std::vector<Condition>& conditions,
                                         const Study& study, double lowest) {
    std::vector<Condition> wet;
    std::ranges::copy_if(conditions, std::back_inserter(wet), std::not_fn(&Condition::dry));
    if (wet.empty()) {
        return {};
    }
    if (!study.liquid) {
        throw std::invalid_argument("wet conditions need a liquid");
    }
    std::vector<WetSetting> pairs;
    for (const auto& c : wet) {
        pairs.push_back({1 / reduced_pressure(c.normal_stress, study.grains, *study.liquid),
                         c.liquid_content, 0});
    }
    const auto levels = inertial_numbers_for(wet, lowest);
    std::vector<WetSetting> settings;
    for (const auto& pair : farthest_first(pairs)) {
        for (const double inertial_number : {levels.front(), levels.back()}) {
            settings.push_back({pair.inverse_pressure, pair.liquid_content, inertial_number});
            if (levels.size() == 1) {
                break;
            }
        }
    }
    return settings;
}

std::vector<std::pair<double, double>> latin_places(const std::vector<WetSetting>& settings,
                                                    std::uint64_t seed) {
    std::map<double, std::vector<std::size_t>> by_inertial_number;
    for (std::size_t k = 0; k < settings.size(); ++k) {
        by_inertial_number[settings[k].inertial_number].push_back(k);
    }
    std::mt19937_64 random(seed);
    std::vector<std::pair<double, double>> places(settings.size());
    for (const auto& [inertial_number, members] : by_inertial_number) {
        const auto n = members.size();
        const auto centre = [&](std::size_t cell) {
            return (2 * static_cast<double>(cell) + 1) / static_cast<double>(n) - 1;
        };
        std::vector<std::size_t> first(n), second(n);
        std::iota(first.begin(), first.end(), std::size_t{0});
        second = first;
        std::ranges::shuffle(first, random);
        std::ranges::shuffle(second, random);
        for (std::size_t k = 0; k < n; ++k) {
            places[members[k]] = {centre(first[k]), centre(second[k])};
        }
    }
    return places;
}

}  // namespace pendular
