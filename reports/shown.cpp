#include "reports/shown.h"

#include <fmt/format.h>

#include <cmath>

namespace pendular {

Shown shown(const Reading& r) {
    const double s = r.condition.normal_stress;
    return {{r.value(0) / s, r.value(1)},
            {std::sqrt(r.covariance(0, 0)) / s, std::sqrt(r.covariance(1, 1))}};
}

Shown mean_of(const std::vector<Reading>& readings) {
    Shown mean{};
    for (std::size_t o = 0; o < 2; ++o) {
        double weights = 0;
        for (const auto& reading : readings) {
            const Shown one = shown(reading);
            const double weight = 1 / (one.error[o] * one.error[o]);
            mean.value[o] += weight * one.value[o];
            weights += weight;
        }
        mean.value[o] /= weights;
        mean.error[o] = 1 / std::sqrt(weights);
    }
    return mean;
}

std::string inertial_text(double inertial_number) {
    return inertial_number == 0 ? "I → 0" : fmt::format("I = {:.3g}", inertial_number);
}

}  // namespace pendular
