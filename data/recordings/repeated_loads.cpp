#include "data/recordings/repeated_loads.h"

#include <set>

#include "data/recordings/test_kinds.h"

namespace pendular {

bool repeats_each_load(const Block& block, const IntervalSeries& series) {
    // More rows at one load, exactly held, would be a recording; chosen.
    constexpr std::size_t most_repeats = 12, fewest_loads = 3;
    if (series.shear_stress.empty() || series.normal_stress.empty() || !series.time.empty() ||
        !series.angular_velocity.empty() || !series.interval.empty() ||
        has_column_of_readings(block) || block.declared_rows)
        return false;
    const std::vector<double>& load = series.normal_stress;
    std::set<double> known;
    for (std::size_t begin = 0, end = 0; begin < load.size(); begin = end) {
        while (end < load.size() && load[end] == load[begin])
            ++end;
        if (end - begin < 2 || end - begin > most_repeats || !known.insert(load[begin]).second)
            return false;
    }
    return known.size() >= fewest_loads;
}

}  // namespace pendular
