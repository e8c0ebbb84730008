#pragma once

#include <omp.h>

#include <cstddef>
#include <utility>

namespace pendular::dem {

/// Calls work(part) for every part, side by side; what a part does must depend on its number
/// alone, so that a result depends on the number of parts and on nothing else.
template <typename Work>
void in_parts(int parts, const Work& work) {
    if (parts == 1) {
        work(0);
        return;
    }
#pragma omp parallel for schedule(static, 1) num_threads(parts)
    for (int part = 0; part < parts; ++part) {
        work(part);
    }
}

/// Range of part `part` of `parts` of so many things, cut at multiples of `grain`.
inline std::pair<std::size_t, std::size_t> range_of(int part, int parts, std::size_t count,
                                                    std::size_t grain = 1) {
    const std::size_t grains = (count + grain - 1) / grain;
    const auto cut = [&](int p) {
        const std::size_t at =
            grains * static_cast<std::size_t>(p) / static_cast<std::size_t>(parts) * grain;
        return at < count ? at : count;
    };
    return {cut(part), cut(part + 1)};
}

}  // namespace pendular::dem
