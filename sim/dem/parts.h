#pragma once

#include <omp.h>

#include <cstddef>
#include <utility>

namespace pendular::dem {

/// Calls work(part) for part = 0 to parts - 1, each call on a thread of its own. If each call
/// depends only on the number `part`, the results do not depend on the scheduling of the threads.
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

/// Returns range number `part`, counted from 0, of `count` items in `parts` ranges of nearly equal
/// size: index of the first item, and index after the last. Each range begins at a multiple of
/// `grain` items (not a grain of a sample).
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
