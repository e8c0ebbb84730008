#include "data/recordings/speed_ramp.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "data/recordings/recording.h"
#include "data/recordings/robust.h"

namespace pendular {
namespace {

/// A speed that changes by 20 % about its mean changes the stress ratio of dry grains by less than
/// 3 %, nearly in proportion, so that the mean stays that at the mean speed.
constexpr double settled = 0.2;

double middle(std::span<const double> speeds) {
    return std::abs(median({speeds.begin(), speeds.end()}));
}

}  // namespace

double SpeedRamp::factor() const {
    const auto [least, most] = std::minmax(first, last);
    return least > 0 ? most / least : std::numeric_limits<double>::infinity();
}

std::string SpeedRamp::change() const {
    const double by = factor();
    if (!std::isfinite(by)) return "from or to rest";
    return fmt::format("by a factor of {:.{}f}", by, by < 10 ? 1 : 0);
}

std::optional<SpeedRamp> speed_ramp(std::span<const double> speeds) {
    if (speeds.size() < shortest_step) return std::nullopt;
    // The medians of the last two quarters of a ramp differ by half of the change over the half.
    const std::size_t quarter = speeds.size() / 4;
    const auto last = speeds.last(quarter), before = speeds.last(2 * quarter).first(quarter);
    const double change = std::abs(middle(last) - middle(before));
    // The difference of two medians of independent values scatters by 1.8 noise/sqrt(quarter).
    const double noise = std::max(sample_noise(last), sample_noise(before));
    const bool changes = change > 0.5 * settled * std::max(middle(last), middle(before)) &&
                         change > 5 * noise / std::sqrt(static_cast<double>(quarter));
    if (!changes) return std::nullopt;
    constexpr std::size_t rows = 3;  // their median is not moved by one spike
    return SpeedRamp{middle(speeds.first(rows)), middle(speeds.last(rows))};
}

}  // namespace pendular
