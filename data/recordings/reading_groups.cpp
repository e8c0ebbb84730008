#include "data/recordings/reading_groups.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

namespace pendular {
namespace {

/// Largest relative difference of the set points of replicates [1]. Controllers hold a set point to
/// 1 or 2 %.
constexpr double set_point_tolerance = 0.02;

bool about_equal(double a, double b) {
    return std::abs(a - b) <= set_point_tolerance * std::max(std::abs(a), std::abs(b));
}

}  // namespace

bool are_replicates(const Reading& a, const Reading& b) {
    constexpr double rounding = 1e-9;  // of the arithmetic: liquid contents are stated numbers
    const bool same_filling =
        a.condition.bead_volume && b.condition.bead_volume
            ? about_equal(*a.condition.bead_volume, *b.condition.bead_volume)
            : a.condition.bead_volume.has_value() == b.condition.bead_volume.has_value();
    const auto &preshear_a = a.condition.preshear_stress, &preshear_b = b.condition.preshear_stress;
    const bool same_preshear = preshear_a && preshear_b
                                   ? about_equal(*preshear_a, *preshear_b)
                                   : preshear_a.has_value() == preshear_b.has_value();
    return same_filling && same_preshear && a.condition.at_failure == b.condition.at_failure &&
           std::abs(a.condition.liquid_content - b.condition.liquid_content) <= rounding &&
           about_equal(a.condition.normal_stress, b.condition.normal_stress) &&
           about_equal(a.condition.inertial_number, b.condition.inertial_number);
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

namespace {

/// Coordinates of a condition in which a bin is divided.
using Place = std::array<double, 4>;

/// Differences of conditions that count as equally large: a decade of the normal stress, 0.1 of
/// sqrt(I), half of the height, twice the duration of the study. Chosen: the first two are the
/// lengths over which a stated discrepancy of the model is correlated.
Place place_of(const Condition& condition, double duration) {
    constexpr double stress = std::numbers::ln10, rate = 0.1, height = 0.5, time = 2;
    return {std::log(condition.normal_stress) / stress, std::sqrt(condition.inertial_number) / rate,
            std::log(condition.height.value_or(1)) / height,
            duration > 0 ? condition.time / (time * duration) : 0};
}

double duration_of(const std::vector<Reading>& readings) {
    const auto [first, last] =
        std::ranges::minmax(readings, {}, [](const Reading& r) { return r.condition.time; });
    return last.condition.time - first.condition.time;
}

/// Properties that readings must have in common to be averaged.
using Sort = std::tuple<std::string, double, bool, double, double, bool, std::size_t, double,
                        double, bool, bool>;

Sort kind_of(const Reading& r, bool by_file) {
    // Readings of one recording share the error of its filling.
    return {by_file || r.within_run_only ? r.origin.file : std::string(),
            r.condition.liquid_content,
            r.condition.at_failure,
            r.condition.preshear_stress.value_or(0),
            r.condition.bead_volume.value_or(0),
            r.condition.height.has_value(),
            r.scatter_group,
            r.scatter_freedom(0),
            r.scatter_freedom(1),
            r.within_run_only,
            r.error_assumed};
}

using Members = std::vector<std::size_t>;

std::vector<Members> by_kind(const std::vector<Reading>& readings, bool by_file) {
    std::map<Sort, Members> kinds;
    for (std::size_t k = 0; k < readings.size(); ++k)
        kinds[kind_of(readings[k], by_file)].push_back(k);
    std::vector<Members> result;
    for (auto& [kind, members] : kinds)
        result.push_back(std::move(members));
    return result;
}

/// Bin of readings, with the coordinate in which its conditions differ most.
struct Bin {
    Members members;
    double extent = 0;  ///< difference of this coordinate within the bin [1]
    std::size_t along = 0;
    double middle = 0;

    bool operator<(const Bin& other) const { return extent < other.extent; }
};

Bin bin_of(Members members, const std::vector<Place>& places) {
    Bin bin{.members = std::move(members)};
    for (std::size_t c = 0; c < Place().size(); ++c) {
        const auto [low, high] =
            std::ranges::minmax(bin.members, {}, [&](std::size_t k) { return places[k][c]; });
        const double extent = places[high][c] - places[low][c];
        if (extent > bin.extent) {
            bin.extent = extent;
            bin.along = c;
            bin.middle = 0.5 * (places[low][c] + places[high][c]);
        }
    }
    return bin;
}

/// Divides bins in two at the middle of the coordinate in which they extend most, the bin of the
/// largest extent first.
std::vector<Members> divided(std::vector<Members> kinds, const std::vector<Place>& places,
                             std::size_t most) {
    std::priority_queue<Bin> bins;
    for (Members& members : kinds)
        bins.push(bin_of(std::move(members), places));
    while (bins.size() < most && bins.top().extent > 0) {
        Bin bin = bins.top();
        bins.pop();
        const auto upper = std::stable_partition(
            bin.members.begin(), bin.members.end(),
            [&](std::size_t k) { return places[k][bin.along] <= bin.middle; });
        bins.push(bin_of({upper, bin.members.end()}, places));
        bin.members.erase(upper, bin.members.end());
        bins.push(bin_of(std::move(bin.members), places));
    }
    std::vector<Members> result;
    for (; !bins.empty(); bins.pop())
        result.push_back(bins.top().members);
    std::ranges::sort(result, {}, [](const Members& members) { return members.front(); });
    return result;
}

/// Mean of a number of each member.
double mean_of(const std::vector<Reading>& readings, const Members& members, const auto& number) {
    return std::accumulate(members.begin(), members.end(), 0.0,
                           [&](double sum, std::size_t k) { return sum + number(readings[k]); }) /
           static_cast<double>(members.size());
}

Condition mean_condition(const std::vector<Reading>& readings, const Members& members) {
    Condition mean = readings[members.front()].condition;
    mean.normal_stress = 1 / mean_of(readings, members, [](const Reading& r) {
                             return 1 / r.condition.normal_stress;
                         });
    mean.inertial_number =
        std::pow(mean_of(readings, members,
                         [](const Reading& r) { return std::sqrt(r.condition.inertial_number); }),
                 2);
    mean.time = mean_of(readings, members, [](const Reading& r) { return r.condition.time; });
    if (mean.height)
        mean.height =
            mean_of(readings, members, [](const Reading& r) { return *r.condition.height; });
    return mean;
}

/// Mean of members, whose stresses are taken at the mean normal stress.
Reading mean_reading(const std::vector<Reading>& readings, const Members& members) {
    Reading mean = readings[members.front()];
    if (members.size() == 1) return mean;
    const auto count = static_cast<double>(members.size());
    mean.condition = mean_condition(readings, members);
    mean.last_line = 0;
    mean.value.setZero();
    mean.covariance.setZero();
    mean.widened_by.setZero();
    mean.shared.clear();
    mean.shear_rate = mean_of(readings, members, [](const Reading& r) { return r.shear_rate; });
    std::map<std::size_t, SharedError> shared;
    for (const std::size_t k : members) {
        const Reading& one = readings[k];
        const Eigen::Vector2d weight(
            mean.condition.normal_stress / one.condition.normal_stress / count, 1 / count);
        const auto weighted = [&](const Eigen::Matrix2d& covariance) {
            return Eigen::Matrix2d(weight.asDiagonal() * covariance * weight.asDiagonal());
        };
        Eigen::Matrix2d own = one.covariance;
        for (const SharedError& error : one.shared) {
            own -= error.size * error.size.transpose();
            SharedError& sum =
                shared.emplace(error.source, SharedError{error.source, {0, 0}, error.known})
                    .first->second;
            sum.size += weight.cwiseProduct(error.size);
        }
        mean.value += weight.cwiseProduct(one.value);
        mean.covariance += weighted(own);
        mean.widened_by += weighted(one.widened_by);
        mean.replicates = std::max(mean.replicates, one.replicates);
    }
    for (const auto& [source, error] : shared) {
        mean.covariance += error.size * error.size.transpose();
        mean.shared.push_back(error);
    }
    return mean;
}

}  // namespace

std::vector<Reading> binned_readings(const std::vector<Reading>& readings, std::size_t most) {
    if (readings.size() <= most) return readings;
    std::vector<Members> kinds = by_kind(readings, true);
    if (kinds.size() > most / 2) kinds = by_kind(readings, false);
    std::vector<Place> places;
    const double duration = duration_of(readings);
    for (const Reading& reading : readings)
        places.push_back(place_of(reading.condition, duration));
    std::vector<Reading> means;
    for (const Members& members : divided(std::move(kinds), places, most))
        means.push_back(mean_reading(readings, members));
    return means;
}

}  // namespace pendular
