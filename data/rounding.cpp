#include "data/rounding.h"

#include <cmath>
#include <numbers>

namespace pendular {

double rounding_correlation(double scatter) {
    double sum = 0, all = 0;
    for (int k = 1; k <= 40; ++k) {
        sum += std::exp(-std::pow(2 * std::numbers::pi * k * scatter, 2)) / (k * k);
        all += 1.0 / (k * k);
    }
    return sum / all;
}

void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  const std::array<bool, 2>& scatter_known, std::vector<Reading>& readings) {
    for (std::size_t g = 0; g < table.groups.size(); ++g) {
        const bool replicated = table.groups[g].size() > 1;
        for (const Eigen::Index o : {0, 1}) {
            for (const std::size_t k : table.groups[g]) {
                Reading& reading = readings[k];
                const double step = reading.resolution(o), variance = step * step / 12;
                if (!(step > 0) || stated[k](o) >= variance) continue;
                const double scatter = std::sqrt(reading.estimated_covariance()(o, o));
                const double common = rounding_correlation(scatter / step) * variance;
                const bool rest_seen = scatter_known[static_cast<std::size_t>(o)] && replicated;
                reading.covariance(o, o) += rest_seen ? common : variance;
                if (!replicated) continue;
                // Numbers after those of the files' errors.
                SharedError error{
                    .source = 2 * (table.files.size() + g) + static_cast<std::size_t>(o),
                    .known = true};
                error.size(o) = error.estimated(o) = std::sqrt(common);
                reading.shared.push_back(error);
            }
        }
    }
}

}  // namespace pendular
