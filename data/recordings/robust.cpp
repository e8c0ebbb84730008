#include "data/recordings/robust.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pendular {

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1) return *middle;
    return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

double robust_deviation(std::span<const double> values) {
    constexpr double normal = 1.4826;  // 1/(quantile of the normal distribution at 3/4)
    std::vector<double> distances(values.begin(), values.end());
    const double centre = median(distances);
    for (double& value : distances)
        value = std::abs(value - centre);
    return normal * median(std::move(distances));
}

double sample_noise(std::span<const double> series) {
    std::vector<double> differences;
    for (std::size_t i = 1; i < series.size(); ++i)
        differences.push_back(series[i] - series[i - 1]);
    return robust_deviation(differences) / std::numbers::sqrt2;
}

double least_step(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    const double rounding = 1e-9 * std::max(std::abs(values.front()), std::abs(values.back()));
    double least = 0;
    for (std::size_t i = 1; i < values.size(); ++i) {
        const double step = values[i] - values[i - 1];
        if (step > rounding && (least == 0 || step < least)) least = step;
    }
    return least;
}

}  // namespace pendular
