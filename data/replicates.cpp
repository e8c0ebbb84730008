#include "data/replicates.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

namespace pendular {
namespace {

constexpr double set_point_tolerance = 0.02;
constexpr double assumed_error = 0.02;
/// From a factor of two on, more replicates are worth a word.
constexpr double worth_a_note = 2;

using Group = std::vector<Reading*>;

bool close(double a, double b) {
    return std::abs(a - b) <= set_point_tolerance * std::max(std::abs(a), std::abs(b));
}

/// Each reading joins the first group whose first reading it replicates.
std::vector<Group> grouped(std::vector<Reading>& readings) {
    std::vector<Group> groups;
    for (Reading& reading : readings) {
        const auto home = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
            return are_replicates(*group.front(), reading);
        });
        if (home == groups.end())
            groups.push_back({&reading});
        else
            home->push_back(&reading);
    }
    return groups;
}

/// (stress ratio, solid fraction): what does not change with the normal stress within 2 %.
Eigen::Vector2d compared(const Reading& reading) {
    return {reading.stress_ratio(), reading.value(1)};
}

/// Covariance relative to the values [1].
Eigen::Matrix2d relative(const Reading& reading) {
    const Eigen::Matrix2d scale = reading.value.cwiseInverse().asDiagonal();
    return scale * reading.covariance * scale;
}

/// Scatter between replicates and errors within them, both relative, and their degrees of freedom.
struct Pooled {
    Eigen::Matrix2d between = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d within = Eigen::Matrix2d::Zero();
    double freedom = 0;
};

void add(const Group& group, Pooled& pooled) {
    const double size = static_cast<double>(group.size());
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    Eigen::Matrix2d within = Eigen::Matrix2d::Zero();
    for (const Reading* reading : group) {
        mean += compared(*reading) / size;
        within += relative(*reading) / size;
    }
    for (const Reading* reading : group) {
        const Eigen::Vector2d deviation = (compared(*reading).array() / mean.array() - 1).matrix();
        pooled.between += deviation * deviation.transpose();
    }
    pooled.within += (size - 1) * within;
    pooled.freedom += size - 1;
}

/// Factor on a standard error estimated with so many degrees of freedom, so that twice the product
/// covers as often as twice a known standard error does: Student's quantile over the normal one.
double widening(double freedom) {
    const double level = boost::math::cdf(boost::math::normal(), 2.0);
    return boost::math::quantile(boost::math::students_t(freedom), level) / 2;
}

/// What the errors within the runs leave unexplained, relative: a covariance.
Eigen::Matrix2d excess(const Pooled& pooled) {
    Eigen::Matrix2d result = Eigen::Matrix2d::Zero();
    if (pooled.freedom == 0) return result;
    const Eigen::Matrix2d difference =
        std::pow(widening(pooled.freedom), 2) * (pooled.between - pooled.within) / pooled.freedom;
    for (int i = 0; i < 2; ++i)
        result(i, i) = std::max(0.0, difference(i, i));
    const double shrunk = difference(0, 1) * (pooled.freedom - 1) / (pooled.freedom + 1);
    const double bound = 0.99 * std::sqrt(result(0, 0) * result(1, 1));
    result(0, 1) = result(1, 0) = std::clamp(shrunk, -bound, bound);
    return result;
}

void assume_missing_errors(Reading& reading) {
    for (int i = 0; i < 2; ++i) {
        if (reading.covariance(i, i) > 0) continue;
        reading.covariance(i, i) = std::pow(assumed_error * reading.value(i), 2);
        reading.error_assumed = true;
    }
}

}  // namespace

Eigen::Matrix2d estimated_covariance(const Reading& reading, const ReplicateScatter& scatter) {
    const Eigen::Matrix2d scale = reading.value.asDiagonal();
    const double surplus = 1 - 1 / (scatter.widening * scatter.widening);
    return reading.covariance - surplus * scale * scatter.excess * scale;
}

bool are_replicates(const Reading& a, const Reading& b) {
    constexpr double rounding = 1e-9;
    const bool same_filling =
        a.condition.bead_volume && b.condition.bead_volume
            ? close(*a.condition.bead_volume, *b.condition.bead_volume)
            : a.condition.bead_volume.has_value() == b.condition.bead_volume.has_value();
    return same_filling &&
           std::abs(a.condition.liquid_content - b.condition.liquid_content) <= rounding &&
           close(a.condition.normal_stress, b.condition.normal_stress) &&
           close(a.condition.inertial_number, b.condition.inertial_number);
}

void pool_replicates(Measurements& measurements) {
    Pooled pooled;
    for (const Group& group : grouped(measurements.readings)) {
        for (Reading* reading : group)
            reading->replicates = static_cast<int>(group.size());
        add(group, pooled);
    }
    const Eigen::Matrix2d added = excess(pooled);
    if (pooled.freedom > 0) {
        measurements.scatter = {added, pooled.freedom, widening(pooled.freedom)};
    }
    if (!added.isZero() && widening(pooled.freedom) >= worth_a_note)
        measurements.notes.push_back(fmt::format(
            "the scatter between replicates is known from {0} only: their standard errors are "
            "widened {1:.1f} times so that two of them cover 95 %; more replicates narrow them",
            pooled.freedom == 1 ? "one pair" : fmt::format("{:.0f} differences", pooled.freedom),
            widening(pooled.freedom)));
    std::ptrdiff_t assumed = 0;
    for (Reading& reading : measurements.readings) {
        const Eigen::Matrix2d scale = reading.value.asDiagonal();
        reading.covariance += scale * added * scale;
        assume_missing_errors(reading);
        assumed += reading.error_assumed;
    }
    if (assumed > 0)
        measurements.notes.push_back(
            fmt::format("{} of {} readings have values without error and without replicates: "
                        "2 % of the value is assumed",
                        assumed, measurements.readings.size()));
}

}  // namespace pendular
