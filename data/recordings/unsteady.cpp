#include "data/recordings/unsteady.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "data/recordings/time_series.h"

namespace pendular {
namespace {

/// Means of successive parts of a series, each of size/parts samples; samples that fill no part are
/// left out.
std::vector<double> part_means(const std::vector<double>& series, std::size_t parts) {
    const std::size_t size = std::max<std::size_t>(1, series.size() / parts);
    std::vector<double> means;
    for (std::size_t i = 0; i + size <= series.size(); i += size)
        means.push_back(mean_of_correlated(std::span(series).subspan(i, size)).value);
    return means;
}

/// Relative change of the mean from the first to the last quarter of a series [1].
double relative_change(const std::vector<double>& series) {
    const std::vector<double> quarters = part_means(series, 4);
    return quarters.front() == 0 ? 0 : quarters.back() / quarters.front() - 1;
}

}  // namespace

double strain_of(const StepSeries& series, const AnnularCell& cell) {
    const double rate = shear_rate(std::abs(mean_of_correlated(series.angular_velocity).value),
                                   mean_of_correlated(series.height).value, cell);
    return rate * (series.time.back() - series.time.front());
}

Remark::Kind looks_like(const StepSeries& series) {
    using enum Remark::Kind;
    // Chosen: the limits decide words in a message alone.
    const double force = relative_change(series.normal_force);
    if (force < -0.2) return unloading;
    if (force > 0.2) return loading;
    if (relative_change(series.height) < -0.01) return consolidation;
    const std::vector<double> torque = part_means(series.torque, 20);
    const auto peak = std::ranges::max_element(torque);
    const bool early = peak - torque.begin() < 3 * static_cast<std::ptrdiff_t>(torque.size()) / 4;
    if (early && torque.back() < 0.95 * *peak) return shear_to_failure;
    return torque.back() > 1.05 * torque[torque.size() / 2] ? stopped_shear : preshear;
}

}  // namespace pendular
