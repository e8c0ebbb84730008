#include "data/recordings/interval_steps.h"

#include <algorithm>
#include <cmath>

namespace pendular {
namespace {

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
        !all_known(recording.normal_force, series.size()))
        return {{.begin = 0, .end = series.size()}};
    recording.line = series.line;
    return split_steps(recording);
}

}  // namespace pendular
