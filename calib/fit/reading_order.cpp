#include "calib/fit/reading_order.h"

#include <algorithm>

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

}  // namespace pendular
