// Liquid bridges: the law against its derivation, and their life from contact to rupture.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <utility>

#include "sim/dem/distant_forces.h"
#include "sim/dem/pair_forces.h"
#include "sim/dem/shear_cell.h"
#include "sim/dem/structure.h"

namespace sim_bridges_test {

using namespace pendular;
using namespace pendular::dem;

constexpr Wetting wetting{.reduced_pressure = 2, .bridge_volume = 4e-3};

/// Two grains that are moved by hand along x, their forces from the lists of a pair each.
struct TwoGrains {
    Grains grains{2};
    dem::Cell cell{20, 20, 20, 0};
    Pairs pairs;
    Material material{.modulus = 3e4, .friction = 0};
    BridgeLaw bridges{wetting};

    TwoGrains() {
        grains.position(0)[0] = 5, grains.position(1)[0] = 6.5, grains.position(0)[1] = 5,
        grains.position(1)[1] = 5, grains.position(0)[2] = 5, grains.position(1)[2] = 5;
        pairs = Pairs(find_pairs_by_brute_force(grains, cell, 0.6));
        pairs.fill_up(PairList::batch);
    }
    /// Force that pulls the second grain towards the first at this gap.
    double attraction(double gap, bool as_distant = false) {
        grains.position(1)[0] = grains.position(0)[0] + 1 + gap;
        const PairLaws laws{cell, {}, material, bridges, 1e-3};
        if (as_distant) {
            grains.net_force.assign(2, {});
            distant_forces(grains, pairs, {0, pairs.size()}, laws, grains.net_force);
        } else {
            pair_forces(grains, pairs, laws);
        }
        return -grains.force(1)[0];
    }
};

/// Force of a bridge between spheres of radius R from the geometry behind the law, in diameters and
/// F0: a parabolic gap H(r) = h + r^2/R filled up to the height He has the volume
/// V = (pi R/2)(He^2 - h^2), and its pressure over the wetted area pulls with F = F0 (1 - h/He).
double derived_force(double gap, double volume) {
    const double radius = 0.5;
    const double filled = std::sqrt(gap * gap + 2 * volume / (std::numbers::pi * radius));
    return 1 - gap / filled;
}

TEST(BridgeLaw, FollowsFromTheVolumeOfAParabolicGap) {
    const BridgeLaw law(wetting);
    for (const double gap : {0.0, 1e-4, 0.01, 0.05, 0.15}) {
        EXPECT_NEAR(law.relative_force(gap), derived_force(gap, wetting.bridge_volume), 1e-14);
    }
    EXPECT_DOUBLE_EQ(law.relative_force(0), 1);
    EXPECT_DOUBLE_EQ(law.pull_off_force, 0.5);
    EXPECT_DOUBLE_EQ(law.rupture_distance, std::cbrt(4e-3));
}

TEST(BridgeLaw, AsPrintedHasHalfTheVolumeInIt) {
    Wetting printed = wetting;
    printed.bridge_force = FormulaVariant::as_printed;
    const double gap = 0.05, half = 2e-3;
    EXPECT_NEAR(BridgeLaw(printed).relative_force(gap), derived_force(gap, half), 1e-14);
    // The printed formula word by word: 1 - 1/sqrt(1 + 2 V0/(pi a h^2)).
    EXPECT_NEAR(BridgeLaw(printed).relative_force(gap),
                1 - 1 / std::sqrt(1 + 2 * 4e-3 / (std::numbers::pi * gap * gap)), 1e-14);
    EXPECT_EQ(BridgeLaw(printed).rupture_distance, BridgeLaw(wetting).rupture_distance);
}

TEST(BridgeLaw, PotentialIsTheWorkUpToRupture) {
    const BridgeLaw law(wetting);
    const double from = 0.01;
    const int steps = 100000;
    double work = 0;
    for (int k = 0; k < steps; ++k) {
        const double width = (law.rupture_distance - from) / steps;
        work += law.pull_off_force * law.relative_force(from + (k + 0.5) * width) * width;
    }
    EXPECT_NEAR(law.potential(from), -work, 1e-9);
    // Formation at contact releases F0 [D0 + sqrt(c) - sqrt(D0^2 + c)].
    const double d = law.rupture_distance, c = 4 * 4e-3 / std::numbers::pi;
    EXPECT_NEAR(law.potential(0), -0.5 * (d + std::sqrt(c) - std::sqrt(d * d + c)), 1e-14);
}

TEST(Bridges, FormOnContactAloneAndBreakAtTheRuptureDistance) {
    TwoGrains two;
    const double rupture = two.bridges.rupture_distance;
    EXPECT_EQ(two.attraction(0.001), 0);  // near, but never in contact
    EXPECT_GT(two.attraction(-1e-6), 0.49);
    EXPECT_NEAR(two.attraction(0.05), 0.5 * derived_force(0.05, 4e-3), 1e-12);
    EXPECT_GT(two.attraction(0.999 * rupture), 0);
    EXPECT_EQ(two.attraction(1.001 * rupture), 0);
    EXPECT_EQ(two.attraction(0.001), 0);  // broken: only a new contact forms it again
    EXPECT_GT(two.attraction(-1e-6), 0.49);
}

TEST(Bridges, PullAlikeInTheNearAndInTheDistantList) {
    TwoGrains two;
    two.attraction(-1e-6);
    for (const double gap : {0.02, 0.07, 0.15}) {
        EXPECT_DOUBLE_EQ(two.attraction(gap, true), two.attraction(gap, false));
    }
    EXPECT_EQ(two.attraction(0.16, true), 0);  // D0 = 0.1587
    EXPECT_EQ(two.attraction(0.05, true), 0);
}

TEST(Bridges, DoNotEnterTheCoulombLimit) {
    // The elastic force at this overlap is 10; with F0 = 5 the net force is 5, the limit still 0.3
    // x 10.
    TwoGrains two;
    two.bridges = BridgeLaw({.reduced_pressure = 0.2, .bridge_volume = 4e-3});
    two.material.friction = 0.3;
    const double overlap = overlap_at(10, two.material.modulus);
    two.grains.velocity(1)[1] = 1;
    for (int step = 0; step < 200; ++step) {
        two.attraction(-overlap);
    }
    EXPECT_NEAR(std::hypot(two.pairs.sy[0], two.pairs.sz[0]), 3, 1e-9);
    EXPECT_NEAR(two.grains.force(1)[0], 10 - 5, 1e-9);
}

using PairSet = std::set<std::pair<int, int>>;

/// The grains of a pair by the numbers that never change.
std::pair<int, int> called_at_first(const Grains& grains, const Neighbours& pairs, std::size_t k) {
    return std::minmax({grains.number[static_cast<std::size_t>(pairs.first[k])],
                        grains.number[static_cast<std::size_t>(pairs.second[k])]});
}

/// Pairs whose gap is below this now, by looking at all of them.
PairSet closer_than(double gap, const ShearCell& sample) {
    Grains wrapped = sample.grains();
    dem::Cell cell = sample.cell();
    cell.reduce_offset();
    for (std::size_t i = 0; i < wrapped.size(); ++i) {
        wrapped.position(i) = cell.wrapped(wrapped.position(i));
    }
    const Neighbours near = find_pairs_by_brute_force(wrapped, cell, gap);
    PairSet result;
    for (std::size_t k = 0; k < near.size(); ++k) {
        result.insert(called_at_first(sample.grains(), near, k));
    }
    return result;
}

PairSet intersection(const PairSet& a, const PairSet& b) {
    PairSet both;
    std::ranges::set_intersection(a, b, std::inserter(both, both.end()));
    return both;
}

TEST(Bridges, AreThoseThatAPairByPairHistoryGives) {
    // A second book keeps every bridge by brute force over all pairs at every step.
    ShearCell sample(150, {.modulus = 5e3, .friction = 0.2}, 0.1, 5, BridgeLaw(wetting));
    ASSERT_TRUE(sample.compress());
    const double rupture = sample.bridges().rupture_distance;
    PairSet book;
    std::size_t broken = 0, compared = 0;
    for (int step = 0; step < 4000; ++step) {
        const PairSet kept = intersection(book, closer_than(rupture, sample));
        broken += book.size() - kept.size();
        book = kept;
        book.merge(closer_than(0, sample));
        sample.step();  // with the forces of the state just looked at
        if (step % 50 != 0) {
            continue;
        }
        PairSet listed;
        for (const auto* list : {&sample.pairs().narrow(), &sample.pairs().distant()}) {
            for (std::size_t k = 0; k < list->size(); ++k) {
                if (list->bridge[k] > 0) {
                    listed.insert(called_at_first(sample.grains(), *list, k));
                }
            }
        }
        // A bridge that this step has stretched beyond rupture may already be gone from the lists.
        const PairSet alive = closer_than(rupture, sample);
        ASSERT_EQ(intersection(listed, alive), intersection(book, alive)) << "step " << step;
        compared += listed.size();
    }
    EXPECT_GT(sample.strain(), 2);
    EXPECT_GT(broken, 500u);
    EXPECT_GT(compared, 80 * 400u);
    EXPECT_GT(sample.pairs().wide_rebuilds(), 10u);
}

TEST(Bridges, NeverPushTheSampleAndLeaveMomentumAlone) {
    ShearCell sample(150, {.modulus = 5e3, .friction = 0.2}, 0.05, 6, BridgeLaw(wetting));
    ASSERT_TRUE(sample.compress());
    for (int step = 0; step < 2000; ++step) {
        sample.step();
    }
    double momentum = 0, largest = 0;
    for (const auto& grain : sample.grains().motion) {
        momentum += grain.velocity[0];
        largest = std::max(largest, std::abs(grain.velocity[0]));
    }
    EXPECT_GT(largest, 0.01);
    EXPECT_NEAR(momentum, 0, 1e-10 * largest * 150);
    EXPECT_GT(sample.pairs().distant().size(), 0u);
}

/// One grain in the middle joined to others at gaps along directions that sample the sphere evenly.
struct Star {
    Grains grains;
    Pairs distant;
    BridgeLaw bridges{wetting};

    template <typename Gap>
    Star(int count, const Gap& gap) : grains(static_cast<std::size_t>(count) + 1) {
        grains.position(0)[0] = grains.position(0)[1] = grains.position(0)[2] = 50;
        for (int k = 0; k < count; ++k) {
            const double up = 1 - (2 * k + 1.0) / count;  // Fibonacci sphere
            const double turn = k * std::numbers::pi * (3 - std::sqrt(5.0));
            const double side = std::sqrt(1 - up * up);
            const double nx = side * std::cos(turn), ny = side * std::sin(turn);
            const double length = 1 + gap(nx * ny);
            const auto i = static_cast<std::size_t>(k) + 1;
            grains.position(i)[0] = 50 + nx * length, grains.position(i)[1] = 50 + ny * length;
            grains.position(i)[2] = 50 + up * length;
            distant.add(0, k + 1, static_cast<std::uint8_t>(image_code::of({})));
            distant.bridge.back() = 1;
        }
    }
    Structure structure() const {
        return structure_of(grains, {100, 100, 100, 0}, {}, distant, {.modulus = 3e4}, bridges);
    }
};

TEST(Structure, GivesTheDistantNetworkOfAnEvenStar) {
    const double gap = 0.05;
    const Star star(2000, [&](double) { return gap; });
    const Structure s = star.structure();
    const double force = derived_force(gap, 4e-3);
    EXPECT_NEAR(s.distant_coordination, 2 * 2000 / 2001.0, 1e-12);
    EXPECT_NEAR(s.distant_force, force, 1e-12);
    EXPECT_NEAR(s.distant_force_gap, force * gap, 1e-12);
    EXPECT_NEAR(s.distant_length, 1.05, 1e-12);
    EXPECT_NEAR(s.fabric_12_distant, 0, 1e-4);
    EXPECT_NEAR(s.force_anisotropy_12_distant, 0, 1e-10);
    EXPECT_EQ(s.contact_coordination, 0);
    // Isotropic: the mean stress is -sum F r/(3 V), and so is each normal stress.
    const double pressure = -2000 * 0.5 * force * 1.05 / (3 * 1e6);
    EXPECT_NEAR(s.capillary_pressure, pressure, 1e-12);
    EXPECT_NEAR(s.capillary_stress_22, pressure, 1e-3 * std::abs(pressure));
}

TEST(Structure, GivesTheAnisotropyOfForceAndLengthByDirection) {
    // Lengths 1.05 + 0.03 n1 n2: (1/4 pi l0) int l n1 n2 = 0.03/(15 x 1.05).
    const Star star(20000, [](double n12) { return 0.05 + 0.03 * n12; });
    const Structure s = star.structure();
    EXPECT_NEAR(s.length_anisotropy_12_distant, 0.03 / (15 * 1.05), 1e-5);
    // Longer bridges pull less: to first order F' 0.03/(15 F).
    const double slope = (derived_force(0.0501, 4e-3) - derived_force(0.0499, 4e-3)) / 0.0002;
    EXPECT_NEAR(s.force_anisotropy_12_distant, slope * 0.03 / (15 * derived_force(0.05, 4e-3)),
                2e-4);
    EXPECT_LT(s.force_anisotropy_12_distant, -0.01);
}

}  // namespace sim_bridges_test
