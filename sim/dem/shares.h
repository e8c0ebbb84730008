#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim/dem/pair_list.h"

namespace pendular::dem {

/// Part of a time step that is done at once: ranges of near and distant pairs, in whole batches,
/// and the range of grains that occur in no later pair. Pairs are sorted by their first grain,
/// which has the lower number. The grains of a section can therefore move as soon as its pairs are
/// done, while they are still in the cache.
struct Section {
    using Range = std::pair<std::size_t, std::size_t>;
    Range grains, near, distant;
};

/// Work of one thread in every step while the neighbour lists are valid. The thread sums the forces
/// of its pairs in an array of its own and moves its grains. As grains are numbered in rows, pairs
/// of other threads act on few of its grains.
struct Share {
    std::vector<Section> sections;
    /// Numbers of the grains of other shares on which pairs of this share act, ascending.
    std::vector<std::int32_t> ghosts;

    Section::Range grains() const {
        return {sections.front().grains.first, sections.back().grains.second};
    }
};

/// Divides the pairs and all `grains` grains of a sample among `parts` threads; returns one share
/// per thread, each with the same number of near pairs (narrow list), as far as whole batches
/// allow.
std::vector<Share> shares_of(const PairList& pairs, std::size_t grains, int parts);

}  // namespace pendular::dem
