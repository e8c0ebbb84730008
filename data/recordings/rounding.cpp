#include "data/recordings/replicate_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pendular {

double rounding_correlation(double scatter) {
    double sum = 0, all = 0;  // over the same terms, so that the result is 1 without scatter
    for (int k = 1; k <= 40; ++k) {
        sum += std::exp(-std::pow(2 * std::numbers::pi * k * scatter, 2)) / (k * k);
        all += 1.0 / (k * k);
    }
    return sum / all;
}

namespace {

double rounding_variance(const Reading& reading, Eigen::Index o) {
    return reading.resolution(o) * reading.resolution(o) / 12;
}

/// Sets `rounding` of all values of an observable, for a given relative variance of a step [1].
void set_rounding(ReplicateTable& table, Eigen::Index o, double step_variance,
                  const std::vector<Reading>& readings) {
    for (ReplicateCluster& cluster : table.clusters) {
        for (ReplicatedValue& value : cluster.values[static_cast<std::size_t>(o)]) {
            const Reading& reading = readings[value.reading];
            const double square = reading.value(o) * reading.value(o);
            const double variance = rounding_variance(reading, o) / square;
            if (!(variance > value.within)) continue;
            const double scatter = std::sqrt(step_variance * square) / reading.resolution(o);
            value.rounding = (1 - rounding_correlation(scatter)) * variance / step_variance;
        }
    }
}

/// Mean of the squared deviations over their variances [1], with the `rounding` in the table.
double normalised_mean_square(const ReplicateTable& table, Eigen::Index o, double step_variance) {
    double sum = 0, freedom = 0;
    for (const ReplicateCluster& cluster : table.clusters) {
        const ScatterSums sums = analyse_scatter(cluster.values[static_cast<std::size_t>(o)], 0);
        sum += sums.within;
        freedom += sums.freedom_within;
    }
    return freedom > 0 ? sum / freedom / step_variance : 0;
}

bool is_rounded(const ReplicateTable& table, Eigen::Index o, const std::vector<Reading>& readings) {
    return std::ranges::any_of(table.clusters, [&](const ReplicateCluster& cluster) {
        return std::ranges::any_of(cluster.values[static_cast<std::size_t>(o)],
                                   [&](const ReplicatedValue& value) {
                                       return readings[value.reading].resolution(o) > 0;
                                   });
    });
}

}  // namespace

void weigh_rounding(ReplicateTable& table, const std::vector<Reading>& readings) {
    for (const Eigen::Index o : {0, 1}) {
        if (!is_rounded(table, o, readings)) continue;
        // Bisection over relative standard deviations from 1e-5 to 1.
        double small = std::log(1e-10), large = std::log(1.0);
        constexpr double fine = 1e-3;  // of ln(variance): 0.05 % of a standard deviation
        while (large - small > fine) {
            const double middle = (small + large) / 2;
            set_rounding(table, o, std::exp(middle), readings);
            (normalised_mean_square(table, o, std::exp(middle)) > 1 ? small : large) = middle;
        }
        set_rounding(table, o, std::exp(large), readings);
    }
}

void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  std::vector<Reading>& readings) {
    for (std::size_t g = 0; g < table.groups.size(); ++g) {
        for (const Eigen::Index o : {0, 1}) {
            for (const std::size_t k : table.groups[g]) {
                Reading& reading = readings[k];
                const double variance = rounding_variance(reading, o);
                if (!(variance > stated[k](o))) continue;
                const double scatter =
                    std::sqrt(reading.estimated_covariance()(o, o)) / reading.resolution(o);
                reading.covariance(o, o) += variance;
                if (table.groups[g].size() < 2) continue;
                // Numbers of sources follow those of the filling errors.
                SharedError error{
                    .source = 2 * (table.files.size() + g) + static_cast<std::size_t>(o),
                    .known = true,
                    .of_rounding = true};
                error.size(o) = std::sqrt(rounding_correlation(scatter) * variance);
                reading.shared.push_back(error);
            }
        }
    }
}

}  // namespace pendular
