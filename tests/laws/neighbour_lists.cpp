// Neighbour lists of a sample large enough for bins, sheared so far that its grains are renumbered
// several times, against books kept from positions alone.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

#include "sim/dem/shear_cell.h"

namespace neighbour_lists_test {

using namespace pendular::dem;

using PairSet = std::set<std::pair<int, int>>;

/// Positions by the numbers that never change, and the distances between nearest images.
struct Positions {
    std::vector<Vector> at;
    Cell cell;

    explicit Positions(const ShearCell& sample) : at(sample.grains().size()), cell(sample.cell()) {
        for (std::size_t i = 0; i < at.size(); ++i) {
            at[static_cast<std::size_t>(sample.grains().number[i])] = sample.grains().position(i);
        }
    }
    double squared_distance(int i, int j) const {
        Vector r = at[static_cast<std::size_t>(j)] - at[static_cast<std::size_t>(i)];
        const double up = std::nearbyint(r[1] / cell.height);
        r -= Vector(up * cell.offset, up * cell.height, 0);
        r -= Vector(cell.length * std::nearbyint(r[0] / cell.length), 0,
                    cell.width * std::nearbyint(r[2] / cell.width));
        return dot(r, r);
    }
    /// Pairs that are closer than a range, in order.
    std::vector<std::pair<int, int>> closer_than(double range) const {
        std::vector<std::pair<int, int>> result;
        const int count = static_cast<int>(at.size());
        for (int i = 0; i < count; ++i) {
            for (int j = i + 1; j < count; ++j) {
                if (squared_distance(i, j) < range * range) {
                    result.emplace_back(i, j);
                }
            }
        }
        return result;
    }
};

/// Pairs of a list by the numbers that never change; a pair must not stand there twice.
template <typename Condition>
PairSet pairs_where(const Grains& grains, const Pairs& pairs, std::size_t count,
                    const Condition& holds) {
    PairSet result;
    for (std::size_t k = 0; k < count; ++k) {
        if (holds(k)) {
            const int i = grains.number[static_cast<std::size_t>(pairs.first[k])];
            const int j = grains.number[static_cast<std::size_t>(pairs.second[k])];
            EXPECT_TRUE(result.insert(std::minmax(i, j)).second) << i << " and " << j;
        }
    }
    return result;
}

/// Contacts and bridges of a sample from the distances of its grains at every step. Pairs are
/// looked for among those that were close at the last look at all pairs, which makes sure that none
/// was missing.
class Book {
  public:
    explicit Book(double rupture) : reach_(1 + rupture) {}

    void look_at_all(const Positions& now) {
        std::vector<Pair> fresh;
        for (const auto& grains : now.closer_than(1.6)) {
            const auto known = std::ranges::lower_bound(pairs_, grains, {}, &Pair::grains);
            const bool found = known != pairs_.end() && known->grains == grains;
            const bool close = now.squared_distance(grains.first, grains.second) < reach_ * reach_;
            ASSERT_TRUE(found || !close || pairs_.empty()) << "look more often";
            fresh.push_back({grains, found && known->joined, false});
        }
        pairs_ = std::move(fresh);
    }
    void step(const Positions& now) {
        for (Pair& pair : pairs_) {
            const double squared = now.squared_distance(pair.grains.first, pair.grains.second);
            pair.touching = squared < 1;
            const bool joined = pair.touching || (pair.joined && squared <= reach_ * reach_);
            broken_ += pair.joined && !joined;
            pair.joined = joined;
        }
    }
    PairSet joined() const { return where(&Pair::joined); }
    PairSet touching() const { return where(&Pair::touching); }
    std::size_t broken() const { return broken_; }

  private:
    struct Pair {
        std::pair<int, int> grains;
        bool joined = false, touching = false;
    };
    PairSet where(bool Pair::*holds) const {
        PairSet result;
        for (const Pair& pair : pairs_) {
            if (pair.*holds) {
                result.insert(result.end(), pair.grains);
            }
        }
        return result;
    }
    double reach_;
    std::vector<Pair> pairs_;
    std::size_t broken_ = 0;
};

constexpr int grains = 1200;
const BridgeLaw wet({.reduced_pressure = 2, .bridge_volume = 4e-3});

TEST(NeighbourLists, HoldTheContactsAndBridgesOfALargeSampleWhileItIsRenumbered) {
    ShearCell sample(grains, {.modulus = 5e3, .friction = 0.2}, 0.1, 5, wet);
    ASSERT_TRUE(sample.compress());
    Book book(wet.rupture_distance);
    auto names = sample.grains().number;
    int renumbered = 0;
    double lowest = 1e9, highest = 0;
    for (int step = 0; step < 4000; ++step) {
        const Positions now(sample);
        if (step % 100 == 0) {
            ASSERT_NO_FATAL_FAILURE(book.look_at_all(now)) << "step " << step;
        }
        book.step(now);
        if (step % 10 == 0) {  // in the lists of the forces about to be found
            const PairSet listed =
                pairs_where(sample.grains(), sample.pairs().narrow(), sample.pairs().live(),
                            [](std::size_t) { return true; });
            ASSERT_TRUE(std::ranges::includes(listed, book.touching())) << "step " << step;
        }
        sample.step();
        renumbered += sample.grains().number != names;
        names = sample.grains().number;
        lowest = std::min(lowest, sample.cell().height);
        highest = std::max(highest, sample.cell().height);
        if (step % 10 != 0) {
            continue;
        }
        const auto joined = [&](const Pairs& pairs, std::size_t count) {
            return pairs_where(sample.grains(), pairs, count,
                               [&](std::size_t k) { return pairs.bridge[k] > 0; });
        };
        PairSet listed = joined(sample.pairs().narrow(), sample.pairs().narrow().size());
        listed.merge(joined(sample.pairs().distant(), sample.pairs().distant().size()));
        // What this step stretches beyond rupture may still stand in the lists or not.
        const Positions moved(sample);
        const auto stretched = [&](const std::pair<int, int>& p) {
            return moved.squared_distance(p.first, p.second) >
                   std::pow(1 + wet.rupture_distance, 2);
        };
        PairSet expected = book.joined();
        std::erase_if(listed, stretched);
        std::erase_if(expected, stretched);
        ASSERT_EQ(listed, expected) << "step " << step;
    }
    EXPECT_GT(sample.strain(), 2.5);
    EXPECT_GE(renumbered, 2);
    EXPECT_GT(book.broken(), 5000u);
    EXPECT_GT(highest - lowest, 0.2);
    EXPECT_GT(sample.pairs().wide_rebuilds(), 10u);
    // However often they were renumbered, every number is there once.
    std::ranges::sort(names);
    std::vector<std::int32_t> all(grains);
    std::iota(all.begin(), all.end(), 0);
    EXPECT_EQ(names, all);
}

TEST(NeighbourLists, AreTheSameInPartsAndWhole) {
    const Sample gas = random_gas(grains, 7);
    for (const double offset : {0.0, -0.4, 0.3}) {
        Cell cell = gas.cell;
        cell.offset = offset * cell.length;
        Grains wrapped = gas.grains;
        for (auto& grain : wrapped.motion) {
            grain.position = cell.wrapped(grain.position);
        }
        const Neighbours whole = find_pairs(wrapped, cell, 0.5),
                         parts = find_pairs(wrapped, cell, 0.5, 3),
                         truth = find_pairs_by_brute_force(wrapped, cell, 0.5);
        ASSERT_GT(truth.size(), 1000u);
        for (const auto& found : {whole, parts}) {
            EXPECT_EQ(found.first, truth.first);
            EXPECT_EQ(found.second, truth.second);
            EXPECT_EQ(found.image, truth.image);
        }
    }
}

TEST(NeighbourLists, RememberContactsAndBridgesWhenBeadsAreRenumbered) {
    ShearCell sample(grains, {.modulus = 5e3, .friction = 0.2}, 0.1, 6, wet);
    ASSERT_TRUE(sample.compress());
    while (sample.strain() < 0.5) {
        sample.step();
    }
    Grains changed = sample.grains();
    Cell cell = sample.cell();
    PairList list = sample.pairs();
    // By pair: tangential force on the grain of the larger number, sqrt(overlap), bridge.
    using Memory = std::tuple<double, double, double, double, double>;
    const auto remembered = [](const Grains& of, const Pairs& pairs) {
        std::map<std::pair<int, int>, Memory> result;
        for (std::size_t k = 0; k < pairs.size(); ++k) {
            const int i = of.number[static_cast<std::size_t>(pairs.first[k])];
            const int j = of.number[static_cast<std::size_t>(pairs.second[k])];
            const double sign = i < j ? 1 : -1;
            if (pairs.root[k] > 0 || pairs.bridge[k] > 0) {
                result[std::minmax(i, j)] = {sign * pairs.sx[k], sign * pairs.sy[k],
                                             sign * pairs.sz[k], pairs.root[k], pairs.bridge[k]};
            }
        }
        return result;
    };
    const auto all = [&](const Grains& of, const PairList& from) {
        auto result = remembered(of, from.narrow());
        result.merge(remembered(of, from.distant()));
        return result;
    };
    const auto before = all(changed, list);
    const auto names = changed.number;
    list.update(changed, cell, 1.5);  // as if sheared so far at once
    ASSERT_NE(changed.number, names);
    EXPECT_EQ(all(changed, list), before);
    EXPECT_GT(before.size(), 2500u);
}

}  // namespace neighbour_lists_test
