#include "sim/dem/shares.h"

#include <algorithm>
#include <cstddef>

#include "sim/dem/parts.h"

namespace pendular::dem {
namespace {

/// Number of near pairs in a section; with their grains they fit into the cache of one core.
constexpr std::size_t pairs_in_section = 4096;

/// Number of pairs whose first grain is below `grain`, rounded up to whole batches.
std::size_t end_of_grains(const Pairs& pairs, std::size_t live, std::size_t grain) {
    const auto begin = pairs.first.begin(), end = begin + static_cast<std::ptrdiff_t>(live);
    const auto at = std::lower_bound(begin, end, static_cast<std::int32_t>(grain));
    const std::size_t batch = PairList::batch;
    return (static_cast<std::size_t>(at - begin) + batch - 1) / batch * batch;
}

/// Divides the pairs and grains of a sample into `count` sections.
std::vector<Section> sections_of(const PairList& pairs, std::size_t grains, int count) {
    const Pairs &near = pairs.narrow(), &distant = pairs.distant();
    std::vector<Section> sections(static_cast<std::size_t>(count));
    Section cut;
    for (int k = 0; k < count; ++k) {
        const std::size_t near_end = range_of(k, count, near.size(), PairList::batch).second;
        const std::size_t grain = k + 1 < count && near_end < pairs.live()
                                      ? static_cast<std::size_t>(near.first[near_end])
                                      : grains;
        const std::size_t distant_end =
            grain < grains ? end_of_grains(distant, pairs.live_distant(), grain) : distant.size();
        cut = {{cut.grains.second, grain},
               {cut.near.second, near_end},
               {cut.distant.second, std::max(distant_end, cut.distant.second)}};
        sections[static_cast<std::size_t>(k)] = cut;
    }
    return sections;
}

void add_ghosts(const Pairs& pairs, std::size_t live, const Section::Range& stretch, Share& share) {
    const auto [begin, end] = share.grains();
    for (std::size_t k = stretch.first; k < std::min(stretch.second, live); ++k) {
        for (const std::int32_t grain : {pairs.first[k], pairs.second[k]}) {
            if (static_cast<std::size_t>(grain) < begin || static_cast<std::size_t>(grain) >= end) {
                share.ghosts.push_back(grain);
            }
        }
    }
}

}  // namespace

std::vector<Share> shares_of(const PairList& pairs, std::size_t grains, int parts) {
    const auto each = static_cast<int>(std::max<std::size_t>(
        1, pairs.narrow().size() / pairs_in_section / static_cast<std::size_t>(parts)));
    const auto sections = sections_of(pairs, grains, parts * each);
    std::vector<Share> shares(static_cast<std::size_t>(parts));
    for (int part = 0; part < parts; ++part) {
        Share& share = shares[static_cast<std::size_t>(part)];
        const auto first = sections.begin() + std::ptrdiff_t{part} * each;
        share.sections.assign(first, first + each);
        if (parts == 1) {
            break;
        }
        for (const Section& section : share.sections) {
            add_ghosts(pairs.narrow(), pairs.live(), section.near, share);
            add_ghosts(pairs.distant(), pairs.live_distant(), section.distant, share);
        }
        std::ranges::sort(share.ghosts);
        const auto repeated = std::unique(share.ghosts.begin(), share.ghosts.end());
        share.ghosts.erase(repeated, share.ghosts.end());
    }
    return shares;
}

}  // namespace pendular::dem
