#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <tuple>

#include "sim/dem/pair_list.h"
#include "sim/dem/shear_cell.h"

namespace sim_pair_list_test {

using namespace pendular::dem;

using Key = std::tuple<int, int, int>;

std::set<Key> keys(const Neighbours& pairs) {
    std::set<Key> result;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        if (pairs.image[k] != image_code::nowhere) {
            result.insert({pairs.first[k], pairs.second[k], pairs.image[k]});
        }
    }
    return result;
}

TEST(FindPairs, AgreesWithBruteForceAtEveryOffset) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> at(0, 1);
    for (const double turn : {-0.5, -0.31, 0.0, 0.2, 0.4999}) {
        const Cell cell{9, 11, 8, turn * 9};
        Grains grains(600);
        for (std::size_t i = 0; i < grains.size(); ++i) {
            grains.position(i)[0] = cell.length * at(random),
            grains.position(i)[1] = cell.height * at(random);
            grains.position(i)[2] = cell.width * at(random);
            grains.position(i) = cell.wrapped(grains.position(i));
        }
        const auto fast = keys(find_pairs(grains, cell, 0.15));
        EXPECT_EQ(fast, keys(find_pairs_by_brute_force(grains, cell, 0.15)));
        EXPECT_GT(fast.size(), 1000u);
    }
}

TEST(FindPairs, FallsBackOnSmallSamples) {
    Grains grains(64);
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> at(0, 3.2);
    for (auto& grain : grains.motion) {
        const double x = at(random), y = at(random), z = at(random);
        grain.position = {x, y, z};
    }
    const Cell cell{3.2, 3.2, 3.2, 1.0};
    for (auto& grain : grains.motion) {
        grain.position = cell.wrapped(grain.position);
    }
    EXPECT_EQ(keys(find_pairs(grains, cell, 0.1)),
              keys(find_pairs_by_brute_force(grains, cell, 0.1)));
}

TEST(PairList, MissesNoContactUnderShearAndHeightChange) {
    // Every contact that brute force finds must be in the list the forces came from, over thousands
    // of steps at a high shear rate, with several turns of the image offset.
    ShearCell sample(200, {.modulus = 5e3, .friction = 0.2}, 0.1, 5);
    ASSERT_TRUE(sample.compress());
    for (int step = 0; step < 6000; ++step) {
        sample.step();
        if (step % 20 != 0) {
            continue;
        }
        std::multiset<std::pair<int, int>> listed;
        const Pairs& narrow = sample.pairs().narrow();
        for (std::size_t k = 0; k < sample.pairs().live(); ++k) {
            listed.insert({narrow.first[k], narrow.second[k]});
        }
        Grains wrapped = sample.grains();
        Cell cell = sample.cell();
        cell.reduce_offset();
        for (std::size_t i = 0; i < wrapped.size(); ++i) {
            wrapped.position(i) = cell.wrapped(wrapped.position(i));
        }
        const Neighbours touching = find_pairs_by_brute_force(wrapped, cell, 0.0);
        for (std::size_t k = 0; k < touching.size(); ++k) {
            ASSERT_EQ(listed.count({touching.first[k], touching.second[k]}), 1u) << "step " << step;
        }
    }
    EXPECT_GT(sample.strain(), 3);
    EXPECT_GT(sample.pairs().wide_rebuilds(), 10u);
    EXPECT_LT(sample.pairs().wide_rebuilds(), sample.steps() / 5);
}

TEST(PairList, FollowsAnAffineShearInWhichNoBeadMovesOfItself) {
    // Only the imposed shear brings grains together: no peculiar displacement warns the list.
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> at(0, 1);
    Cell cell{7, 7, 7, 0};
    Grains grains(300);
    for (std::size_t i = 0; i < grains.size(); ++i) {
        grains.position(i)[0] = cell.length * at(random),
        grains.position(i)[1] = cell.height * at(random);
        grains.position(i)[2] = cell.width * at(random);
    }
    PairList list;
    list.rebuild(grains, cell);
    const double step = 2e-3;
    for (int k = 0; k < 1500; ++k) {
        for (std::size_t i = 0; i < grains.size(); ++i) {
            grains.position(i)[0] += step * grains.position(i)[1];
        }
        cell.offset += step * cell.height;
        list.update(grains, cell, step);
        std::set<std::pair<int, int>> listed;
        for (std::size_t n = 0; n < list.live(); ++n) {
            listed.insert({list.narrow().first[n], list.narrow().second[n]});
        }
        Grains wrapped = grains;
        Cell reduced = cell;
        reduced.reduce_offset();
        for (std::size_t i = 0; i < wrapped.size(); ++i) {
            wrapped.position(i) = reduced.wrapped(wrapped.position(i));
        }
        const Neighbours touching = find_pairs_by_brute_force(wrapped, reduced, 0.0);
        for (std::size_t n = 0; n < touching.size(); ++n) {
            ASSERT_TRUE(listed.contains({touching.first[n], touching.second[n]}))
                << "strain " << k * step;
        }
    }
}

TEST(PairList, KeepsWhatContactsRemember) {
    ShearCell sample(200, {.modulus = 5e3, .friction = 0.2}, 0.05, 6);
    ASSERT_TRUE(sample.compress());
    for (int step = 0; step < 500; ++step) {
        sample.step();
    }
    Grains grains = sample.grains();
    Cell cell = sample.cell();
    PairList list = sample.pairs();
    const auto remembered = [](const PairList& pairs) {
        std::map<std::pair<int, int>, std::tuple<double, double, double, double>> result;
        for (std::size_t k = 0; k < pairs.live(); ++k) {
            const Pairs& p = pairs.narrow();
            if (p.root[k] > 0) {
                result[{p.first[k], p.second[k]}] = {p.sx[k], p.sy[k], p.sz[k], p.root[k]};
            }
        }
        return result;
    };
    const auto before = remembered(list);
    list.rebuild(grains, cell);
    EXPECT_EQ(remembered(list), before);
    EXPECT_GT(before.size(), 100u);
}

}  // namespace sim_pair_list_test
