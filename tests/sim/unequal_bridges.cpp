// Liquid bridges that differ in volume: the distribution of the volumes, force and rupture of a
// bridge of its own volume, and the liquid of a sample.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "sim/catalogue/effect.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/pair_forces.h"
#include "sim/dem/shear_cell.h"
#include "sim/dem/structure.h"
#include "sim/runs/ensemble.h"
#include "sim/runs/run_request.h"

namespace unequal_bridges_test {

using namespace pendular;
using namespace pendular::dem;

constexpr double bridge_volume = 4e-3;

EffectValues unequal(double deviation, double exchange = 0) {
    return {"unequal-bridges", {deviation, exchange}};
}

/// Volumes over V0 that bridges get between pairs of grains in contact, in random directions.
std::vector<double> drawn_volumes(double deviation, std::size_t count) {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    std::vector<double> nx(count), ny(count), nz(count), gap(count, 0.0), diameter(count, 1.0),
        joined(count, 1.0), force(count, 0.5), volume(count, 0.0);
    for (std::size_t k = 0; k < count; ++k) {
        const double x = normal(random), y = normal(random), z = normal(random);
        const double length = std::hypot(x, y, z);
        nx[k] = x / length, ny[k] = y / length, nz[k] = z / length;
    }
    double* history[] = {volume.data()};
    PairBatch batch{};
    batch.size = count;
    batch.nx = nx.data(), batch.ny = ny.data(), batch.nz = nz.data();
    batch.gap = gap.data(), batch.diameter = diameter.data();
    batch.joined = joined.data(), batch.capillary = force.data();
    batch.contact_history = history;
    const GrainEffects effects = grain_effects({unequal(deviation)}, true);
    const BridgeLaw bridges =
        effects.changed(BridgeLaw(Wetting{.reduced_pressure = 2, .bridge_volume = bridge_volume}));
    effects.bridge(batch, {}, bridges);
    const std::vector<double> first = volume;
    effects.bridge(batch, {}, bridges);
    EXPECT_EQ(volume, first);  // a bridge keeps its volume
    return volume;
}

TEST(UnequalBridges, HaveLognormalVolumesOfMeanV0) {
    for (const double deviation : {0.2, 0.5, 1.0}) {
        const std::vector<double> volumes = drawn_volumes(deviation, 40'000);
        const auto count = static_cast<double>(volumes.size());
        double sum = 0, squares = 0, logs = 0, log_squares = 0;
        for (const double v : volumes) {
            sum += v, squares += v * v;
            logs += std::log(v), log_squares += std::log(v) * std::log(v);
        }
        const double mean = sum / count, found = std::sqrt(squares / count - mean * mean);
        EXPECT_NEAR(mean, 1, 4 * found / std::sqrt(count)) << deviation;
        // Volumes beyond three standard deviations of the logarithm are cut off, which takes 2.7 %
        // of the variance of the logarithm.
        const double width = std::sqrt(std::log1p(deviation * deviation));
        const double log_variance = log_squares / count - std::pow(logs / count, 2);
        EXPECT_NEAR(std::sqrt(log_variance), width * std::sqrt(1 - 0.0266), 0.015 * width);
        EXPECT_GT(found, 0.85 * deviation);
        EXPECT_LT(found, 1.02 * deviation);
    }
}

TEST(UnequalBridges, PullAndBreakAsTheirOwnVolumeSays) {
    const GrainEffects effects = grain_effects({unequal(1)}, true);
    const BridgeLaw base(Wetting{.reduced_pressure = 2, .bridge_volume = bridge_volume});
    const BridgeLaw bridges = effects.changed(base);
    Grains grains{2};
    const dem::Cell cell{20, 20, 20, 0};
    double smallest = 10, largest = 0;
    for (int turn = 0; turn < 40; ++turn) {
        const double angle = 0.1 + 0.035 * turn;
        const auto part = [&](double gap) {
            grains.position(1) = {5 + (1 + gap) * std::cos(angle), 5 + (1 + gap) * std::sin(angle),
                                  5};
        };
        grains.position(0) = {5, 5, 5};
        part(1e-9);
        Pairs pairs(find_pairs_by_brute_force(grains, cell, 0.6), effects.contact_history());
        pairs.fill_up(PairList::batch);
        pairs.bridge[0] = 1;
        const auto attraction = [&](double gap) {
            part(gap);
            grains.net_force.assign(2, {});
            const PairLaws laws{cell,    {}, {.modulus = 3e4}, bridges, 1e-3, EnergyAccounting::off,
                                &effects};
            pair_forces(grains, pairs, {0, pairs.size()}, laws, grains.net_force);
            return std::hypot(grains.force(1)[0], grains.force(1)[1]);
        };
        EXPECT_NEAR(attraction(1e-9), base.pull_off_force, 1e-6);
        const double own = std::abs(pairs.contact_history[0][0]);
        const double rupture = std::cbrt(own * bridge_volume);
        BridgeLaw law = base;
        law.curvature = 4 * own * bridge_volume / std::numbers::pi;
        for (const double share : {0.1, 0.5, 0.999}) {
            EXPECT_NEAR(attraction(share * rupture), law.attraction(share * rupture), 1e-9);
        }
        EXPECT_EQ(attraction(1.001 * rupture), 0);
        EXPECT_EQ(attraction(0.5 * rupture), 0);  // it forms again on contact only
        EXPECT_EQ(pairs.contact_history[0][0], 0);
        smallest = std::min(smallest, own);
        largest = std::max(largest, own);
    }
    EXPECT_LT(smallest, 0.5);
    EXPECT_GT(largest, 2);
}

TEST(UnequalBridges, DrawOneVolumeWhereBridgesFormWithoutContact) {
    // Two grains at rest, closer than the largest bridge reaches: those whose volume does not reach
    // must not draw again until one does.
    const GrainEffects effects = grain_effects({{"reversible-bridges", {1}}, unequal(1)}, true);
    const BridgeLaw bridges =
        effects.changed(BridgeLaw(Wetting{.reduced_pressure = 2, .bridge_volume = bridge_volume}));
    const double gap = 0.9 * std::cbrt(bridge_volume);
    Grains grains{2};
    const dem::Cell cell{20, 20, 20, 0};
    int joined = 0;
    for (int turn = 0; turn < 40; ++turn) {
        double volume = 0;
        for (int step = 0; step < 50; ++step) {
            const double angle =
                0.1 + 0.035 * turn + 1e-6 * step;  // the direction changes a little
            grains.position(0) = {5, 5, 5};
            grains.position(1) = {5 + (1 + gap) * std::cos(angle), 5 + (1 + gap) * std::sin(angle),
                                  5};
            Pairs pairs(find_pairs_by_brute_force(grains, cell, 0.6), effects.contact_history());
            pairs.fill_up(PairList::batch);
            pairs.contact_history[0][0] = volume;
            grains.net_force.assign(2, {});
            const PairLaws laws{cell,    {}, {.modulus = 3e4}, bridges, 1e-3, EnergyAccounting::off,
                                &effects};
            pair_forces(grains, pairs, {0, pairs.size()}, laws, grains.net_force);
            if (step > 0) {
                EXPECT_EQ(pairs.contact_history[0][0], volume);
            }
            volume = pairs.contact_history[0][0];
            if (step == 49) joined += pairs.bridge[0] == 1;
        }
    }
    EXPECT_GT(joined, 5);
    EXPECT_LT(joined, 35);
}

TEST(UnequalBridges, CountTheLiquidThatTheyHold) {
    const RunParameters p{.friction = 0.1,
                          .inertial_number = 0.05,
                          .stiffness_number = 300,
                          .wetting = Wetting{2, bridge_volume},
                          .grains = 200,
                          .strain = 2,
                          .seed = 3,
                          .effects = {unequal(1)}};
    const RunResult run = simulate(p);
    const double of_mean_bridges =
        liquid_content(bridge_volume, run[Observable::contact_coordination].value +
                                          run[Observable::distant_coordination].value);
    const double ratio = run[Observable::liquid_content].value / of_mean_bridges;
    EXPECT_NEAR(ratio, 1, 0.2);
    // Small bridges break sooner, so that the ones that last hold more than V0.
    EXPECT_GT(ratio, 1.01);

    ShearCell cell(150, {.modulus = 5e3, .friction = 0.3}, 0.05, 9, BridgeLaw(*p.wetting), 1,
                   grain_effects({unequal(1)}, true));
    ASSERT_TRUE(cell.compress());
    double count = 0, volume = 0;
    for (int step = 0; step < 500; ++step) {
        cell.step();
    }
    for (const Pairs* list : {&cell.pairs().narrow(), &cell.pairs().distant()}) {
        for (std::size_t k = 0; k < list->size(); ++k) {
            const double own = std::abs(list->history_of(k).front());
            if (list->bridge[k] == 1) {
                EXPECT_GT(own, 0) << k;  // no bridge without liquid
            }
            count += list->bridge[k];
            volume += list->bridge[k] * own;
        }
    }
    EXPECT_GT(count, 300);
    EXPECT_NEAR(mean_bridge_volume(cell.pairs(), cell.effects()), volume / count, 1e-12);
}

/// Number of bridges of a sample, sum of their volumes over V0, and sum of the squared volumes.
std::array<double, 3> sums_of_volumes(const PairList& pairs) {
    std::array<double, 3> sums{};
    for (const Pairs* list : {&pairs.narrow(), &pairs.distant()}) {
        for (std::size_t k = 0; k < list->size(); ++k) {
            const double volume = list->bridge[k] * std::abs(list->history_of(k).front());
            sums[0] += list->bridge[k], sums[1] += volume, sums[2] += volume * volume;
        }
    }
    return sums;
}

double relative_deviation(const std::array<double, 3>& sums) {
    const double mean = sums[1] / sums[0];
    return std::sqrt(sums[2] / sums[0] - mean * mean) / mean;
}

/// Sample in steady flow whose bridges differ in volume and exchange liquid at this rate.
ShearCell sheared(double exchange, int steps) {
    ShearCell cell(150, {.modulus = 5e3, .friction = 0.3}, 0.05, 9,
                   BridgeLaw(Wetting{2, bridge_volume}), 1,
                   grain_effects({unequal(1, exchange)}, true));
    if (!cell.compress()) throw std::logic_error("the sample was not compressed");
    for (int step = 0; step < steps; ++step) {
        cell.step();
    }
    return cell;
}

TEST(UnequalBridges, ExchangeLiquidAndLoseNone) {
    const ShearCell cell = sheared(0, 500);
    PairList pairs = cell.pairs();
    const std::array<double, 3> before = sums_of_volumes(pairs);
    ASSERT_GT(before[0], 300);
    LiquidExchange exchange;
    for (int step = 0; step < 1000; ++step) {
        exchange.flow(pairs, 0, cell.grains().size(), 0.01);
    }
    const std::array<double, 3> after = sums_of_volumes(pairs);
    EXPECT_EQ(after[0], before[0]);
    EXPECT_NEAR(after[1] / before[1], 1, 1e-12);
    // Ten times the time of exchange: volumes differ much less, and no bridge is empty.
    EXPECT_LT(relative_deviation(after), 0.3 * relative_deviation(before));
    for (const Pairs* list : {&pairs.narrow(), &pairs.distant()}) {
        for (std::size_t k = 0; k < list->size(); ++k) {
            if (list->bridge[k] == 1) {
                EXPECT_GT(std::abs(list->history_of(k).front()), 0);
            }
        }
    }
}

TEST(UnequalBridges, RelaxAtTheStatedRate) {
    // Three grains in a row: the middle one has two bridges, of 1/2 and 3/2 V0, whose difference D
    // obeys dD/d(strain) = rate/2 D - rate D: each has the mean of both on one side only.
    Grains grains{3};
    for (int i = 0; i < 3; ++i) {
        grains.position(static_cast<std::size_t>(i)) = {5 + 0.999 * i, 5, 5};
    }
    dem::Cell cell{20, 20, 20, 0};
    PairList pairs(0.2, 1, {.contact_history = 1});
    pairs.rebuild(grains, cell);
    ASSERT_GE(pairs.narrow().size(), 2u);
    int bridges = 0;
    for (std::size_t k = 0; k < pairs.narrow().size(); ++k) {
        if (pairs.narrow().first[k] == pairs.narrow().second[k]) continue;  // a placeholder
        pairs.narrow().bridge[k] = 1;
        pairs.narrow().contact_history[0][k] = bridges++ == 0 ? -0.5 : 1.5;
    }
    ASSERT_EQ(bridges, 2);
    LiquidExchange exchange;
    const double rate = 0.7, strain = 1e-4;
    for (int step = 0; step < 10'000; ++step) {
        exchange.flow(pairs, 0, 3, rate * strain);
    }
    std::vector<double> volumes;
    for (std::size_t k = 0; k < pairs.narrow().size(); ++k) {
        if (pairs.narrow().bridge[k] > 0) volumes.push_back(pairs.narrow().contact_history[0][k]);
    }
    EXPECT_LT(volumes[0], 0);  // the sign follows the order of the grains
    EXPECT_NEAR(volumes[1] + volumes[0] * -1, 2, 1e-12);
    EXPECT_NEAR(volumes[1] - std::abs(volumes[0]), std::exp(-rate / 2), 1e-4);
}

TEST(UnequalBridges, AreMoreAlikeInAFlowWhereLiquidIsExchanged) {
    const double without = relative_deviation(sums_of_volumes(sheared(0, 4000).pairs()));
    const double slow = relative_deviation(sums_of_volumes(sheared(1, 4000).pairs()));
    const double fast = relative_deviation(sums_of_volumes(sheared(1000, 4000).pairs()));
    EXPECT_LT(slow, 0.95 * without);
    EXPECT_LT(fast, 0.1 * slow);
}

TEST(UnequalBridges, KeepTheirVolumesWhereGrainsMoveApart) {
    // Volumes of bridges that last, by the grains that they join, before and after lists are
    // renewed.
    ShearCell cell = sheared(0, 500);
    const auto volumes = [&] {
        std::map<std::pair<std::int32_t, std::int32_t>, double> result;
        for (const Pairs* list : {&cell.pairs().narrow(), &cell.pairs().distant()}) {
            for (std::size_t k = 0; k < list->size(); ++k) {
                if (list->bridge[k] == 1) {
                    result[{list->first[k], list->second[k]}] = list->history_of(k).front();
                }
            }
        }
        return result;
    };
    int renewals = 0, compared = 0;
    for (int step = 0; step < 2000; ++step) {
        const auto before = volumes();
        const std::size_t lists = cell.pairs().renewals();
        cell.step();
        if (cell.pairs().renewals() == lists) continue;
        ++renewals;
        const auto after = volumes();
        // Where grains were renumbered, few pairs have the names that they had.
        int kept = 0, changed = 0;
        for (const auto& [pair, volume] : after) {
            const auto known = before.find(pair);
            if (known != before.end()) (known->second == volume ? kept : changed) += 1;
        }
        if (kept < changed) continue;
        EXPECT_LE(changed, 2) << step;  // a bridge that broke and formed again
        compared += kept;
    }
    EXPECT_GT(renewals, 5);
    EXPECT_GT(compared, 2000);
}

TEST(UnequalBridges, KeepTheNamesOfRunsWithoutExchange) {
    EXPECT_EQ(effects_text({unequal(0.5)}), "unequal-bridges.deviation=0.5");
    EXPECT_EQ(effects_from("unequal-bridges.deviation=0.5"), std::vector{unequal(0.5)});
    EXPECT_EQ(effects_from(effects_text({unequal(0.5, 3)})), std::vector{unequal(0.5, 3)});
}

}  // namespace unequal_bridges_test
