#include "analysis/misfit/unstated_speeds.h"

#include <algorithm>
#include <cmath>

#include "data/quantities/statistics.h"
#include "data/recordings/reading_groups.h"

namespace pendular {
namespace {

/// p value [1] from which a correlation counts as chance: that at which a model counts as
/// describing the readings.
constexpr double chance = 1e-3;
/// How many times repetitions must scatter as much as their stated errors allow [1]. Chosen: errors
/// are seldom known to better than a factor of 2.
constexpr double much_scatter = 2;

bool scatter_beyond_errors(const Measurements& measurements) {
    const std::vector<Remark> notes = measurements.notes();
    return std::ranges::any_of(notes, [](const Remark& note) {
        return note.kind == Remark::Kind::errors_below_scatter && note.relative >= much_scatter;
    });
}

/// Whether no normal stress has readings that state different inertial numbers.
bool state_one_speed(const std::vector<Reading>& readings) {
    std::vector<Condition> seen;
    for (const Reading& reading : readings) {
        const Condition& here = reading.condition;
        const auto same = std::ranges::find_if(seen, [&](const Condition& other) {
            return same_set_point(other.normal_stress, here.normal_stress);
        });
        if (same == seen.end())
            seen.push_back(here);
        else if (!same_set_point(same->inertial_number, here.inertial_number))
            return false;
    }
    return true;
}

/// Sums of squares and products of the relative deviations of both values of a reading from the
/// means of its repetitions.
struct Deviations {
    Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
    /// Largest number of repetitions of one condition. The k-th repetitions of all conditions may
    /// belong to one filling and share its deviation: only as many are surely independent.
    std::size_t independent = 0;

    void add(const std::vector<Reading>& readings, const std::vector<std::size_t>& group) {
        Eigen::Vector2d mean = Eigen::Vector2d::Zero();
        for (const std::size_t k : group)
            mean += relative(readings[k]) / static_cast<double>(group.size());
        for (const std::size_t k : group) {
            const Eigen::Vector2d off = (relative(readings[k]) - mean).cwiseQuotient(mean);
            products += off * off.transpose();
        }
        independent = std::max(independent, group.size());
    }
    static Eigen::Vector2d relative(const Reading& reading) {
        return {reading.stress_ratio(), reading.value(1)};
    }
    double correlation() const {
        return products(0, 1) / std::sqrt(products(0, 0) * products(1, 1));
    }
};

}  // namespace

std::optional<UnstatedSpeeds> unstated_speeds(const Measurements& measurements) {
    const std::vector<Reading>& readings = measurements.readings;
    if (!scatter_beyond_errors(measurements) || !state_one_speed(readings)) return std::nullopt;
    Deviations deviations;
    for (const std::vector<std::size_t>& group : replicate_groups(readings))
        deviations.add(readings, group);
    const double r = deviations.correlation();
    const double freedom = static_cast<double>(deviations.independent) - 2;
    if (!(r < 0) || freedom < 1) return std::nullopt;
    const double t = -r * std::sqrt(freedom / std::max(1 - r * r, 1e-12));
    if (students_t_tail(t, freedom) > chance) return std::nullopt;
    return UnstatedSpeeds{r};
}

}  // namespace pendular
