#include "data/recordings/interval_steps.h"

#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

/// Whether values differ by more than the 5 % that part steps (steps.cpp).
bool differ(const std::vector<double>& values) {
    constexpr double least_change = 0.05;
    if (values.empty()) return false;
    const auto [least, greatest] = std::ranges::minmax_element(values);
    return *greatest - *least > least_change * std::max(std::abs(*least), std::abs(*greatest));
}

bool all_known(const std::vector<double>& values, std::size_t size) {
    return values.size() == size &&
           std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace

std::vector<Step> steps_of(const IntervalSeries& series) {
    Recording recording;
    recording.angular_velocity = series.angular_velocity;
    recording.normal_force = series.normal();
    if (!all_known(recording.angular_velocity, series.size()) ||
        !all_known(recording.normal_force, series.size()) ||
        !(differ(recording.angular_velocity) || differ(recording.normal_force)))
        return {{.begin = 0, .end = series.size()}};
    recording.line = series.line;
    return split_steps(recording);
}

}  // namespace pendular
