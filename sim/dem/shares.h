#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Pairs, in whole batches, and the grains of which none is in a later pair: as pairs are ordered
/// by their first and lower grain, these can move once the pairs are done, while still in the
/// cache.
struct Section {
    using Range = std::pair<std::size_t, std::size_t>;
    Range grains, near, distant;
};

/// Work of one of several threads in every step while the lists are valid. The thread sums the
/// forces of its pairs in an array of its own and moves its grains. As grains are numbered in rows,
/// few pairs of other threads act on them.
struct Share {
    std::vector<Section> sections;
    std::vector<std::int32_t> ghosts;  ///< grains of other shares that its pairs push, ascending

    Section::Range grains() const {
        return {sections.front().grains.first, sections.back().grains.second};
    }
};

/// Shares with as many near pairs each as whole batches allow.
std::vector<Share> shares_of(const PairList& pairs, std::size_t grains, int parts);

}  // namespace pendular::dem
