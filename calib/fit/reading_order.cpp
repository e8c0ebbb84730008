#include "calib/fit/reading_order.h"

#include <fmt/format.h>

#include <algorithm>

#include "data/recordings/binned_readings.h"

namespace pendular {

std::size_t dry_count(const std::vector<Reading>& readings) {
    return static_cast<std::size_t>(
        std::ranges::count_if(readings, [](const Reading& r) { return r.condition.dry(); }));
}

std::vector<Reading> part(const std::vector<Reading>& readings, std::size_t from, std::size_t to) {
    return {readings.begin() + static_cast<std::ptrdiff_t>(from),
            readings.begin() + static_cast<std::ptrdiff_t>(to)};
}

std::vector<Reading> dry_first(const Measurements& measurements) {
    auto readings = measurements.readings;
    std::stable_partition(readings.begin(), readings.end(),
                          [](const Reading& r) { return r.condition.dry(); });
    return readings;
}

std::vector<Reading> readings_to_fit(const Measurements& measurements) {
    return binned_readings(dry_first(measurements), most_fitted);
}

std::optional<std::string> note_on_means(std::size_t used, std::size_t measured) {
    if (used >= measured) return {};
    return fmt::format(
        "Fits and tests use the means of {} bins of neighbouring conditions in place of the {} "
        "readings.",
        used, measured);
}

}  // namespace pendular
