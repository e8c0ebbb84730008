#pragma once

#include <algorithm>

#include "tests/support/ordinary_studies.h"

namespace pendular {

/// Counts the studies of independent recordings of which one is taken for a copy of another: two to
/// six recordings of white or correlated noise, in turn with usual, large and no scatter between
/// fillings and steps. Without such scatter, replicates agree as well as their rows allow.
/// @param first seed of the first study; further studies have the following seeds
inline int honest_studies_with_copies(int studies, std::uint64_t first) {
    const OrdinaryNoise noises[] = {
        {},
        {.correlation_rows = 10, .filling = 0, .step = 0},
        {.torque = 0.01, .correlation_rows = 0.2, .filling = 0, .step = 0},
        {.filling = 0.04, .step = 0.02}};
    int count = 0;
    for (int k = 0; k < studies; ++k) {
        const Measurements all =
            study_of(2 + k % 5, first + static_cast<std::uint64_t>(k), noises[k % 4]);
        count += std::ranges::any_of(all.remarks, [](const Remark& remark) {
            return remark.kind == Remark::Kind::copied_readings;
        });
    }
    return count;
}

}  // namespace pendular
