#include "data/recordings/spikes.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "data/recordings/robust.h"

namespace pendular {
namespace {

constexpr std::ptrdiff_t reach = 5;  // samples on each side of the median
constexpr double noises = 20, least_share = 0.05, most_samples = 0.05;
constexpr std::size_t longest = 3;  // samples; too few of 11 to move their median far

double local_median(std::span<const double> series, std::size_t at) {
    const auto place = static_cast<std::ptrdiff_t>(at);
    const auto first = std::max<std::ptrdiff_t>(0, place - reach);
    const auto last = std::min(std::ssize(series), place + reach + 1);
    return median({series.begin() + first, series.begin() + last});
}

/// Indices that belong to runs of at most `longest` successive indices.
std::vector<std::size_t> short_runs(const std::vector<std::size_t>& places) {
    std::vector<std::size_t> result;
    for (std::size_t begin = 0; begin < places.size();) {
        std::size_t end = begin + 1;
        while (end < places.size() && places[end] == places[end - 1] + 1)
            ++end;
        if (end - begin <= longest) {
            result.insert(result.end(), places.begin() + static_cast<std::ptrdiff_t>(begin),
                          places.begin() + static_cast<std::ptrdiff_t>(end));
        }
        begin = end;
    }
    return result;
}

}  // namespace

std::vector<std::size_t> spikes(std::span<const double> series) {
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

std::vector<std::size_t> take_out_spikes(StepSeries& series) {
    std::set<std::size_t> changed;
    for (std::vector<double>* column : {&series.torque, &series.normal_force, &series.height}) {
        const std::vector<double> as_read = *column;
        for (const std::size_t k : spikes(as_read)) {
            (*column)[k] = local_median(as_read, k);
            changed.insert(k);
        }
    }
    return {changed.begin(), changed.end()};
}

}  // namespace pendular
