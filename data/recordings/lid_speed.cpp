#include "data/recordings/lid_speed.h"

#include <algorithm>
#include <cmath>

#include "data/quantities/statistics.h"
#include "data/recordings/spikes.h"
#include "data/recordings/time_series.h"

namespace pendular {
namespace {

/// Rows in succession that no spike has, which is replaced instead.
constexpr std::size_t fewest_rows = longest_spike + 1;

/// Successive rows, from `begin` to `end` - 1.
struct Run {
    std::size_t begin = 0, end = 0;
    std::size_t size() const { return end - begin; }
};

/// Whether all speeds lie within 20 %, told in one pass: so do those of nearly all steps.
bool all_alike(std::span<const double> speeds) {
    const auto [least, greatest] = std::ranges::minmax(speeds);
    return greatest - least <=
           settled_speed * std::max({std::abs(least), std::abs(greatest), 1e-300});
}

/// Runs of rows that are off the speed of a part of them.
std::vector<Run> runs_off(std::span<const double> speeds, std::span<const double> part) {
    // Of normal noise, one row in 2 million differs by 5 standard deviations.
    constexpr double deviations = 5;
    const double usual = median({part.begin(), part.end()});
    const double off =
        std::max(settled_speed * std::abs(usual), deviations * robust_deviation(part));
    std::vector<Run> runs;
    for (std::size_t i = 0; i < speeds.size(); ++i) {
        if (!(std::abs(speeds[i] - usual) > off)) continue;
        if (!runs.empty() && runs.back().end == i)
            ++runs.back().end;
        else
            runs.push_back({i, i + 1});
    }
    return runs;
}

/// Whether most rows off the speed stand in runs that no spike or rounding makes.
bool mostly_long(const std::vector<Run>& runs) {
    std::size_t all = 0, in_long = 0;
    for (const Run& run : runs) {
        all += run.size();
        if (run.size() >= fewest_rows) in_long += run.size();
    }
    return 2 * in_long > all;
}

/// Whether nearly all speeds have one sign, with magnitudes within a factor of ten.
bool of_one_sense(std::span<const double> speeds) {
    constexpr double aside = 0.05, least_of_greatest = 0.1;
    std::vector<double> sorted(speeds.begin(), speeds.end());
    std::ranges::sort(sorted);
    const auto few = static_cast<std::size_t>(aside * static_cast<double>(sorted.size()));
    const double least = sorted[few], greatest = sorted[sorted.size() - 1 - few];
    const auto [slow, fast] = std::minmax({std::abs(least), std::abs(greatest)});
    return least * greatest > 0 && slow > least_of_greatest * fast;
}

}  // namespace

bool turns(std::span<const double> angular_velocity) {
    const auto differs = [](std::span<const double> speeds) {
        const Mean mean = mean_of_correlated(speeds);
        // Less may be the noise of a speed at rest.
        return std::abs(mean.value) > 3 * mean.standard_error;
    };
    if (differs(angular_velocity)) return true;
    std::vector<double> speeds(angular_velocity.begin(), angular_velocity.end());
    return (!replace_spikes(speeds, settled_speed).empty() && differs(speeds)) ||
           (speeds.size() >= fewest_rows && of_one_sense(speeds));
}

std::vector<std::size_t> breaks_of_speed(std::span<const double> angular_velocity) {
    std::vector<std::size_t> breaks;
    if (angular_velocity.size() <= fewest_rows || all_alike(angular_velocity)) return breaks;
    const std::vector<Run> runs = runs_off(angular_velocity, angular_velocity);
    const std::size_t size = angular_velocity.size();
    const bool at_ends_alone = std::ranges::all_of(
        runs, [&](const Run& run) { return run.begin == 0 || run.end == size; });
    if (!at_ends_alone && !mostly_long(runs)) return breaks;
    for (const Run& run : runs)
        if (run.begin > 0 && (run.size() >= fewest_rows || run.end == size))
            breaks.push_back(run.begin);
    return breaks;
}

std::size_t begin_at_speed(std::span<const double> angular_velocity) {
    if (angular_velocity.size() < 2 * fewest_rows || all_alike(angular_velocity)) return 0;
    const std::vector<Run> runs =
        runs_off(angular_velocity, angular_velocity.last(angular_velocity.size() / 4));
    std::size_t begin = 0;
    for (const Run& run : runs)
        if (run.begin == 0 || run.size() >= fewest_rows) begin = run.end;
    return begin < angular_velocity.size() ? begin : 0;
}

bool turns_back_and_forth(std::span<const double> angular_velocity, std::span<const double> time) {
    // Path of the lid [rad] from which on it is not at rest: a tenth of a turn.
    constexpr double least_path = 0.6, least_share = 0.25;
    double forth = 0, back = 0;
    for (std::size_t i = 1; i < angular_velocity.size(); ++i) {
        const double angle = angular_velocity[i] * (time[i] - time[i - 1]);
        if (!std::isfinite(angle)) continue;
        (angle > 0 ? forth : back) += std::abs(angle);
    }
    // Slow reversals spread far beyond the noise from row to row; noise about zero does not.
    const double noise = sample_noise(angular_velocity);
    const double usual = robust_deviation(angular_velocity);
    return forth + back > least_path && std::min(forth, back) > least_share * (forth + back) &&
           usual > 3 * noise;
}

}  // namespace pendular
