#include "data/recordings/spikes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "data/quantities/statistics.h"

namespace pendular {
namespace {

// Chosen: only errors of reading are taken out, far beyond the noise and what stick-slip does. A
// series with many of them is rough, not spiky.
constexpr std::ptrdiff_t reach = 5;  // samples on each side of the median
constexpr double noises = 20, most_samples = 0.05;

double local_median(std::span<const double> series, std::size_t at) {
    const auto place = static_cast<std::ptrdiff_t>(at);
    const auto first = std::max<std::ptrdiff_t>(0, place - reach);
    const auto last = std::min(std::ssize(series), place + reach + 1);
    return median({series.begin() + first, series.begin() + last});
}

/// Whether no value can differ by `least_share` from a median of others, told in one pass.
bool all_near(std::span<const double> series, double least_share) {
    const auto [least, greatest] = std::ranges::minmax(series);
    return least * greatest > 0 &&
           greatest - least <= least_share * std::min(std::abs(least), std::abs(greatest));
}

/// Indices that belong to runs of at most `longest_spike` successive indices.
std::vector<std::size_t> short_runs(const std::vector<std::size_t>& places) {
    std::vector<std::size_t> result;
    for (std::size_t begin = 0; begin < places.size();) {
        std::size_t end = begin + 1;
        while (end < places.size() && places[end] == places[end - 1] + 1)
            ++end;
        if (end - begin <= longest_spike) {
            result.insert(result.end(), places.begin() + static_cast<std::ptrdiff_t>(begin),
                          places.begin() + static_cast<std::ptrdiff_t>(end));
        }
        begin = end;
    }
    return result;
}

}  // namespace

std::vector<std::size_t> spikes(std::span<const double> series, double least_share) {
    if (series.empty() || all_near(series, least_share)) return {};
    const double noise = sample_noise(series);
    std::vector<std::size_t> far;
    // Samples at the ends have too few neighbours on one side to tell a spike from a rise.
    for (std::size_t k = reach; k + reach < series.size(); ++k) {
        const double usual = local_median(series, k);
        if (std::abs(series[k] - usual) > std::max(noises * noise, least_share * std::abs(usual)))
            far.push_back(k);
    }
    std::vector<std::size_t> found = short_runs(far);
    if (static_cast<double>(found.size()) > most_samples * static_cast<double>(series.size()))
        found.clear();
    return found;
}

std::vector<std::size_t> replace_spikes(std::vector<double>& series, double least_share) {
    const std::vector<double> as_read = series;
    std::vector<std::size_t> found = spikes(as_read, least_share);
    for (const std::size_t k : found)
        series[k] = local_median(as_read, k);
    return found;
}

}  // namespace pendular
