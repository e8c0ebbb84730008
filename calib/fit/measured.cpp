#include "calib/fit/measured.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

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

/// Adds the covariances between readings due to shared errors; the covariance of each reading
/// contains these errors already.
void add_shared_errors(const std::vector<Reading>& readings, Measured& measured) {
    struct Part {
        Eigen::Index entry;
        Eigen::Vector2d size;
    };
    std::map<std::size_t, std::vector<Part>> sources;
    for (std::size_t k = 0; k < readings.size(); ++k) {
        for (const SharedError& error : readings[k].shared) {
            sources[error.source].push_back({2 * static_cast<Eigen::Index>(k), error.size});
        }
    }
    for (const auto& [source, parts] : sources) {
        for (const Part& a : parts) {
            for (const Part& b : parts) {
                if (a.entry == b.entry) continue;
                measured.covariance.block<2, 2>(a.entry, b.entry) += a.size * b.size.transpose();
            }
        }
    }
}

}  // namespace

Measured stack(const std::vector<Reading>& readings, const std::vector<DirectMeasurement>& direct) {
    const auto n = static_cast<Eigen::Index>(readings.size());
    const auto all = 2 * n + static_cast<Eigen::Index>(direct.size());
    Measured measured{Eigen::VectorXd(all), Eigen::MatrixXd::Zero(all, all),
                      Eigen::MatrixXd::Zero(all, all)};
    for (Eigen::Index k = 0; k < n; ++k) {
        const Reading& reading = readings[static_cast<std::size_t>(k)];
        measured.value.segment<2>(2 * k) = reading.value;
        measured.covariance.block<2, 2>(2 * k, 2 * k) = reading.estimated_covariance();
        measured.widening.block<2, 2>(2 * k, 2 * k) = reading.widened_by;
        if (reading.fraction_unknown()) measured.unknown.push_back(2 * k + 1);
    }
    add_shared_errors(readings, measured);
    for (std::size_t k = 0; k < direct.size(); ++k) {
        const auto entry = 2 * n + static_cast<Eigen::Index>(k);
        measured.value(entry) = direct[k].value;
        measured.covariance(entry, entry) = std::pow(direct[k].standard_error, 2);
    }
    return measured;
}

}  // namespace pendular
