// Effects on grains between two grains, against closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "sim/dem/grain_effects.h"
#include "sim/dem/pair_forces.h"
#include "sim/dem/shear_cell.h"
#include "sim/runs/run_request.h"

namespace sim_grain_effects_test {

using namespace pendular;
using namespace pendular::dem;

constexpr Wetting wetting{.reduced_pressure = 2, .bridge_volume = 4e-3};  // F0 = 0.5

/// Two grains along direction 1 that are moved by hand, with effects between them.
struct TwoGrains {
    Grains grains{2};
    dem::Cell cell{20, 20, 20, 0};
    Pairs pairs;
    Material material{.modulus = 3e4, .friction = 0, .damping = 0};
    GrainEffects effects;
    BridgeLaw bridges;
    double dt = 1e-3;

    explicit TwoGrains(const std::vector<EffectValues>& on, bool wet = true,
                       const Wetting& liquid = wetting)
        : effects(grain_effects(on, wet)),
          bridges(wet ? effects.changed(BridgeLaw(liquid)) : BridgeLaw()) {
        grains.position(0) = {5, 5, 5};
        set_gap(0.1);
        pairs = Pairs(find_pairs_by_brute_force(grains, cell, 0.6), effects.contact_history());
        pairs.fill_up(PairList::batch);
    }
    void set_gap(double gap) { grains.position(1) = {6 + gap, 5, 5}; }
    void join() { pairs.bridge[0] = 1; }
    void forces() {
        const PairLaws laws{cell, {}, material, bridges, dt, EnergyAccounting::off, &effects};
        grains.net_force.assign(2, {});
        pair_forces(grains, pairs, {0, pairs.size()}, laws, grains.net_force);
    }
    /// Force that draws the grains together at this gap.
    double attraction(double gap) {
        set_gap(gap);
        forces();
        return -grains.force(1)[0];
    }
};

EffectValues on(const std::string& effect, double value = 1) {
    return {effect, {value}};
}

TEST(RollingResistance, StopsSpinsThatRollAtItsPlasticLimit) {
    // Held together, spinning against each other about direction 3 the grains roll and do not
    // slide. Past the elastic range each is slowed down by the torque M = coefficient F_N/2:
    // I dw/dt = -M, I = 1/10. What is left when the spring gives back its energy M^2/(2 K_r), K_r =
    // K_T/4, is a angular velocity below M/sqrt(2 K_r I) of either grain.
    const double coefficient = 0.2, force = 5, torque = coefficient * force / 2;
    TwoGrains two({on("rolling-resistance", coefficient)}, false);
    two.dt = 1e-4;
    two.material.friction = 0.5;
    const double overlap = overlap_at(force, two.material.modulus);
    two.set_gap(-overlap);
    const double start = 20;
    two.grains.angular_velocity(0)[2] = start, two.grains.angular_velocity(1)[2] = -start;
    const auto turn_for = [&](double time) {
        double largest = 0;
        for (int step = 0; step < time / two.dt; ++step) {
            two.forces();
            for (int i = 0; i < 2; ++i) {
                two.grains.angular_velocity(i) += two.dt / moment_of_inertia * two.grains.torque(i);
            }
            largest = std::max(largest, std::abs(two.grains.angular_velocity(1)[2]));
        }
        return largest;
    };
    turn_for(1);
    const double after = two.grains.angular_velocity(0)[2];
    turn_for(2);
    EXPECT_NEAR(after - two.grains.angular_velocity(0)[2], 2 * torque / moment_of_inertia, 1e-2);
    EXPECT_NEAR(two.grains.angular_velocity(0)[2], -two.grains.angular_velocity(1)[2], 1e-9);
    EXPECT_NEAR(two.grains.force(1)[1], 0, 1e-9);  // no sliding force
    turn_for(start * moment_of_inertia / torque - 3 + 0.2);
    const double stiffness =
        tangential_ratio(0.3) * Hertz::at(overlap, two.material.modulus).normal_stiffness / 4;
    EXPECT_LE(turn_for(1), 1.01 * torque / std::sqrt(2 * stiffness * moment_of_inertia));
    // Twisting about the normal goes on as it was.
    two.grains.angular_velocity(0)[0] = 1;
    turn_for(0.1);
    EXPECT_NEAR(two.grains.angular_velocity(0)[0], 1, 1e-9);
}

TEST(WillettBridges, PullAsThePublishedFitSays) {
    const auto relative = [](double gap, double volume) {
        TwoGrains two({on("willett-bridges")}, true, {2, volume});
        two.join();
        return 2 * two.attraction(gap);
    };
    // At contact, in F0 (the effect's own comment); an overlap of nothing.
    EXPECT_NEAR(relative(0, 5e-4), 0.89, 0.01);
    EXPECT_NEAR(relative(0, 8e-3), 0.80, 0.01);
    // The short form in use for small volumes, F = F0/(1 + 1.05 s + 2.5 s^2), s = h sqrt(R/V), h
    // the whole gap; it is good to some per cent. Half the gap in it would be off by a factor of 2
    // at s = 1.
    const double volume = 1e-4 / 8, unit = std::sqrt(volume / 0.5);
    for (const double s : {0.0, 0.3, 1.0}) {
        const double expected = 1 / (1 + 1.05 * s + 2.5 * s * s);
        EXPECT_NEAR(relative(s * unit, volume), expected, 0.1 * expected) << s;
    }
    for (const double v : {5e-4, 2e-3, 8e-3}) {
        double before = 1;  // below F0 too
        for (double gap = 0; gap < std::cbrt(v); gap += 0.01) {
            const double force = relative(gap, v);
            EXPECT_LT(force, before) << v << ' ' << gap;
            EXPECT_GT(force, 0);
            before = force;
        }
    }
}

TEST(ViscousBridges, ResistApproachAndPartingByLubrication) {
    // (3/2) pi eta R^2 X^2 v/(h + 0.01), R = 1/2, X = 1 - h/sqrt(h^2 + 4 V0/pi) (the effect's
    // equation), beside the attraction that grains at rest have.
    const double viscosity = 0.3, speed = 0.2;
    for (const double gap : {-1e-4, 0.0, 0.02, 0.1}) {
        TwoGrains two({on("viscous-bridges", viscosity)});
        two.join();
        const double at_rest = two.attraction(gap);
        const double h = std::max(gap, 0.0);
        const double wetted = 1 - h / std::sqrt(h * h + 4 * 4e-3 / std::numbers::pi);
        const double expected =
            1.5 * std::numbers::pi * viscosity * 0.25 * wetted * wetted * speed / (h + 0.01);
        two.grains.velocity(0)[0] = speed / 2, two.grains.velocity(1)[0] = -speed / 2;
        EXPECT_NEAR(at_rest - two.attraction(gap), expected, 1e-12 * expected + 1e-13);
        two.grains.velocity(0)[0] = -speed / 2, two.grains.velocity(1)[0] = speed / 2;
        EXPECT_NEAR(two.attraction(gap) - at_rest, expected, 1e-12 * expected + 1e-13);
        // Across the normal nothing is added.
        two.grains.velocity(1)[1] = 1;
        two.forces();
        EXPECT_EQ(two.grains.force(1)[1], 0);
    }
    TwoGrains without({on("viscous-bridges", viscosity)});
    without.grains.velocity(1)[0] = -speed;
    EXPECT_EQ(without.attraction(0.02), 0);
}

TEST(ReversibleBridges, JoinBeadsThatNeverTouched) {
    TwoGrains two({on("reversible-bridges")});
    const double rupture = std::cbrt(4e-3);
    EXPECT_EQ(two.attraction(1.001 * rupture), 0);
    const double force = two.attraction(0.9 * rupture);
    EXPECT_NEAR(force, 0.5 * BridgeLaw(wetting).relative_force(0.9 * rupture), 1e-12);
    EXPECT_EQ(two.attraction(1.001 * rupture), 0);
    EXPECT_NEAR(two.attraction(0.9 * rupture), force, 1e-12);
}

TEST(CapillaryCoulomb, LimitsFrictionByTheNetForce) {
    // At this overlap the elastic force is 10; the bridge pulls with 5, or with more than that.
    for (const double pull : {5.0, 12.0}) {
        TwoGrains two({on("capillary-coulomb")}, true,
                      {.reduced_pressure = 1 / pull, .bridge_volume = 4e-3});
        two.material.friction = 0.3;
        two.grains.velocity(1)[1] = 1;
        two.set_gap(-overlap_at(10, two.material.modulus));
        for (int step = 0; step < 200; ++step) {
            two.forces();
        }
        EXPECT_NEAR(std::hypot(two.pairs.sy[0], two.pairs.sz[0]), 0.3 * std::max(0.0, 10 - pull),
                    1e-9);
    }
}

TEST(DryAdhesion, HoldsUpToItsPullOffForceAndNoFurther) {
    const double pull_off = 0.8;
    const auto parts = [&](double pull) {
        TwoGrains two({on("dry-adhesion", pull_off)}, false);
        two.material.damping = 0.98;
        two.set_gap(-overlap_at(pull_off, two.material.modulus));
        for (int step = 0; step < 4000; ++step) {
            two.forces();
            for (int i = 0; i < 2; ++i) {
                const double outside = i == 0 ? -pull : pull;
                two.grains.velocity(i)[0] += two.dt * (two.grains.force(i)[0] + outside);
                two.grains.position(i)[0] += two.dt * two.grains.velocity(i)[0];
            }
        }
        return two.grains.position(1)[0] - two.grains.position(0)[0] > 1;
    };
    EXPECT_FALSE(parts(0.98 * pull_off));
    EXPECT_TRUE(parts(1.02 * pull_off));
    TwoGrains near({on("dry-adhesion", pull_off)}, false);
    EXPECT_EQ(near.attraction(1e-9), 0);
    // Net force in contact: less the elastic one.
    EXPECT_NEAR(near.attraction(-overlap_at(0.3, near.material.modulus)), 0.5, 1e-12);
}

TEST(RuptureDistance, MovesTheGapAtWhichBridgesBreak) {
    for (const double factor : {0.5, 1.6}) {
        TwoGrains two({on("rupture-distance", factor)});
        const double rupture = factor * std::cbrt(4e-3);
        EXPECT_GT(two.attraction(-1e-6), 0.4);
        const double gap = 0.999 * rupture;
        EXPECT_NEAR(two.attraction(gap), 0.5 * BridgeLaw(wetting).relative_force(gap), 1e-12);
        EXPECT_EQ(two.attraction(1.001 * rupture), 0);
        EXPECT_EQ(two.attraction(0.5 * rupture), 0);  // broken for good
    }
}

TEST(Polydispersity, SpreadsDiametersEvenlyAndCountsTheirVolume) {
    const double deviation = 0.2;
    const GrainEffects effects = grain_effects({on("polydispersity", deviation)}, false);
    const auto diameters = effects.diameters(1000, 3);
    double mean = 0, square = 0, volume = 0;
    for (const double d : diameters) {
        mean += d / 1000, square += d * d / 1000, volume += std::numbers::pi / 6 * d * d * d;
    }
    EXPECT_NEAR(mean, 1, 1e-12);
    // Of n quantiles of a uniform distribution: sqrt(1 - 1/n^2) of its deviation.
    EXPECT_NEAR(std::sqrt(square - mean * mean), deviation, 1e-6);
    const auto [least, greatest] = std::ranges::minmax(diameters);
    EXPECT_NEAR(greatest - least, 2 * std::sqrt(3) * deviation, 1e-3);
    const auto others = effects.diameters(1000, 4);
    EXPECT_NE(diameters, others);
    EXPECT_EQ(std::multiset<double>(diameters.begin(), diameters.end()),
              std::multiset<double>(others.begin(), others.end()));
    const ShearCell cell(1000, {.modulus = 3e4}, 0.1, 3, {}, 1, effects);
    EXPECT_NEAR(cell.solid_fraction(), volume / cell.cell().volume(), 1e-12);
    // The mean cube of a uniform spread is 1 + 3 deviation^2.
    EXPECT_NEAR(volume, 1000 * std::numbers::pi / 6 * (1 + 3 * deviation * deviation), 1e-2);
}

TEST(Polydispersity, KeepsMomentumAndEnergyInElasticImpacts) {
    // Head on, from rest in the centre of mass: grains of masses d^3 leave as fast as they came.
    const double small = 0.7, large = 1.3, speed = 0.1;
    const double m1 = small * small * small, m2 = large * large * large;
    Sample sample{Grains(2), {20, 20, 20, 0}};
    sample.grains.diameters = {small, large};
    // Far enough for the time step to follow its fraction before they meet.
    sample.grains.position(0) = {9.5, 10, 10}, sample.grains.position(1) = {10.52, 10, 10};
    sample.grains.velocity(0) = {speed * m2 / (m1 + m2), 0, 0};
    sample.grains.velocity(1) = {-speed * m1 / (m1 + m2), 0, 0};
    ShearCell cell(sample, {.modulus = 1e6, .damping = 0}, Flow{}, {}, 1,
                   grain_effects({on("polydispersity", 0.3)}, false));
    cell.set_time_step_fraction(1e-3);
    const auto grain = [&](int which) {
        return static_cast<std::size_t>(cell.grains().number[0] == which ? 0 : 1);
    };
    const auto touching = [&] { return cell.pairs().narrow().root[0] > 0; };
    do {
        cell.step();
    } while (!touching());
    // The grains meet where their surfaces do.
    const double distance =
        cell.grains().position(grain(1))[0] - cell.grains().position(grain(0))[0];
    EXPECT_NEAR(distance, (small + large) / 2, 1e-4);
    while (touching()) {
        cell.step();
    }
    const double v1 = cell.grains().velocity(grain(0))[0], v2 = cell.grains().velocity(grain(1))[0];
    EXPECT_NEAR(m1 * v1 + m2 * v2, 0, 1e-12);
    EXPECT_NEAR(v2 - v1, speed, 1e-3 * speed);
    // Reduced mass times speed squared, as before; half of it, summed by the integrator.
    EXPECT_NEAR(cell.kinetic_energy(), 0.5 * m1 * m2 / (m1 + m2) * speed * speed,
                2e-3 * 0.5 * m1 * m2 / (m1 + m2) * speed * speed);
}

}  // namespace sim_grain_effects_test
