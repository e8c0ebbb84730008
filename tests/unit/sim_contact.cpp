// Two beads meet: the contact law against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/dem/pair_forces.h"

using namespace pendular::dem;

namespace {

/// Two beads approaching along x in a large, resting cell.
struct Collision {
    Beads beads{2};
    Cell cell{20, 20, 20, 0};
    Pairs pairs;
    Material material;
    double dt, time = 0, contact_time = 0;

    Collision(double modulus, double damping, double approach, double step) : dt(step) {
        material = {.modulus = modulus, .friction = 0, .damping = damping};
        beads.x = {9, 10.001}, beads.y = {10, 10}, beads.z = {10, 10};
        beads.vx = {approach / 2, -approach / 2};
        pairs = find_pairs_by_brute_force(beads, cell, 1.5);
        while (pairs.size() % PairList::batch != 0) {
            pairs.add(0, 0, image_code::nowhere);
        }
    }
    double separation_speed() const { return beads.vx[1] - beads.vx[0]; }
    void step() {
        pair_forces(beads, pairs, cell, {}, material, dt);
        for (int i = 0; i < 2; ++i) {
            beads.vx[i] += dt * beads.fx[i];
            beads.x[i] += dt * beads.vx[i];
        }
        contact_time += pairs.root[0] > 0 ? dt : 0;
        time += dt;
    }
    void until_parted() {
        while (contact_time == 0 || pairs.root[0] > 0) {
            step();
        }
    }
};

}  // namespace

TEST(HertzContact, LastsAsLongAsHertzSays) {
    // F = (E~/3) h^(3/2), m_eff = 1/2: with k = E~/3 the collision lasts
    // 2.9432 (h_max/v), h_max = (5 m_eff v^2/(4 k))^(2/5).       Landau & Lifshitz, Elasticity,
    // section 9
    const double modulus = 1e5, speed = 0.1;
    const double deepest = std::pow(5 * 0.5 * speed * speed / (4 * modulus / 3), 0.4);
    Collision collision(modulus, 0, speed, 1e-6);
    collision.until_parted();
    EXPECT_NEAR(collision.contact_time, 2.9432 * deepest / speed, 2e-3 * 2.9432 * deepest / speed);
    EXPECT_NEAR(collision.separation_speed(), speed, 1e-4 * speed);  // elastic
}

TEST(HertzContact, ReboundsWithTheRestitutionOfItsDashpot) {
    // A dashpot of zeta 2 sqrt(m_eff K_N), K_N the tangent stiffness, gives a speed-independent
    // restitution e = exp(-pi z/sqrt(1 - z^2)), z = zeta sqrt(6/5), as sqrt(K_N) h' is exact for
    // the variable h^(5/4); here sqrt(2 m K_N) = 2 sqrt(m_eff K_N) for m_eff = m/2.
    for (const double zeta : {0.1, 0.3}) {
        const double z = zeta * std::sqrt(1.2);
        const double restitution = std::exp(-std::numbers::pi * z / std::sqrt(1 - z * z));
        for (const double speed : {0.02, 0.2}) {
            Collision collision(1e5, zeta, speed, 2e-6);
            collision.until_parted();
            EXPECT_NEAR(collision.separation_speed() / speed, restitution, 5e-3 * restitution)
                << "zeta " << zeta << ", speed " << speed;
        }
    }
}

TEST(HertzContact, SticksTogetherNoLongerThanItIsDamped) {
    // From zeta = sqrt(5/6) = 0.913 on the dashpot does not let the beads rebound.
    Collision collision(1e5, 0.98, 0.1, 2e-6);
    while (collision.time < 0.5) {
        collision.step();
    }
    EXPECT_LT(collision.separation_speed(), 1e-3);
}

TEST(MindlinContact, SlidesAtTheCoulombLimitAndSpinsTheBeadsUp) {
    // Pressed together and dragged past one another: the elastic normal force is that of the
    // overlap, the tangential force mu times it, and both beads turn the same way.
    Collision c(1e5, 0.98, 0, 1e-5);
    c.material.friction = 0.2;
    c.beads.x = {9.5, 10.49};
    c.beads.vx = {0, 0};
    c.beads.vy = {-1, 1};
    for (int step = 0; step < 200; ++step) {
        pair_forces(c.beads, c.pairs, c.cell, {}, c.material, c.dt);
    }
    const double elastic = Hertz::at(0.01, 1e5).elastic;
    EXPECT_NEAR(c.beads.fy[1], -0.2 * elastic, 1e-9 * elastic);
    EXPECT_NEAR(c.beads.fx[1], elastic, 1e-9 * elastic);
    EXPECT_NEAR(c.beads.tz[0], c.beads.tz[1], 1e-12);
    EXPECT_NEAR(c.beads.tz[1], 0.495 * 0.2 * elastic, 1e-9 * elastic);
}

TEST(MindlinContact, IsAsStiffAsTheRatioOfMindlinSays) {
    // Before it slides, K_T = K_N (2 - 2 nu)/(2 - nu) times the tangential displacement.
    Collision c(1e5, 0, 0, 1e-4);
    c.material.friction = 10;
    c.beads.x = {9.5, 10.49};
    c.beads.vx = {0, 0};
    c.beads.vz = {0, 0.001};
    for (int step = 0; step < 10; ++step) {
        pair_forces(c.beads, c.pairs, c.cell, {}, c.material, c.dt);
    }
    const double stiffness = Hertz::at(0.01, 1e5).normal_stiffness * (2 - 0.6) / (2 - 0.3);
    EXPECT_NEAR(c.beads.fz[1], -stiffness * 10 * 1e-4 * 0.001, 1e-6 * stiffness * 1e-6);
}

namespace {

/// A pair at rest, overlapping by 0.01 along x, that remembers a tangential force of (0, 1, 0).
Collision stuck_pair(double step) {
    Collision c(1e5, 0, 0, step);
    c.material.friction = 10;
    c.beads.x = {9.505, 10.495};
    c.beads.vx = {0, 0};
    pair_forces(c.beads, c.pairs, c.cell, {}, c.material, c.dt);  // into contact
    c.pairs.sy[0] = 1;
    return c;
}

}  // namespace

TEST(MindlinContact, TurnsItsTangentialForceWithThePair) {
    // A rigid quarter turn about z: no surface moves against the other, and the remembered force
    // turns from +y to -x with the pair. Each step errs by (rate dt)^2.
    const int steps = 20000;
    const double angle = 0.5 * std::numbers::pi, rate = 1, dt = angle / rate / steps;
    Collision c = stuck_pair(dt);
    c.beads.wz = {rate, rate};
    for (int step = 1; step <= steps; ++step) {
        const double phi = angle * step / steps, x = 0.495 * std::cos(phi),
                     y = 0.495 * std::sin(phi);
        c.beads.x = {10 - x, 10 + x}, c.beads.y = {10 - y, 10 + y};
        c.beads.vx = {rate * y, -rate * y}, c.beads.vy = {-rate * x, rate * x};
        pair_forces(c.beads, c.pairs, c.cell, {}, c.material, c.dt);
    }
    EXPECT_NEAR(c.pairs.sx[0], -1, 1e-2);
    EXPECT_NEAR(c.pairs.sy[0], 0, 1e-2);
    EXPECT_NEAR(c.pairs.sz[0], 0, 1e-9);
}

TEST(MindlinContact, SpinsItsTangentialForceAboutItsNormal) {
    // Both beads spin about the normal at the same rate: the force goes round with them, from +y to
    // +z after a quarter turn about x.
    const int steps = 20000;
    const double dt = 0.5 * std::numbers::pi / steps;
    Collision c = stuck_pair(dt);
    c.beads.wx = {1, 1};
    for (int step = 0; step < steps; ++step) {
        pair_forces(c.beads, c.pairs, c.cell, {}, c.material, c.dt);
    }
    EXPECT_NEAR(c.pairs.sy[0], 0, 1e-2);
    EXPECT_NEAR(c.pairs.sz[0], 1, 1e-2);
}

TEST(MindlinContact, LosesTangentialForceInTheLoopAsItUnloads) {
    // From overlap 0.01 to 0.0025 K_T halves, and so does the force; back again it stays.
    Collision c = stuck_pair(1e-4);
    c.beads.x = {9.50125, 10.49875};
    pair_forces(c.beads, c.pairs, c.cell, {}, c.material, c.dt);
    EXPECT_NEAR(c.pairs.sy[0], 0.5, 1e-9);
    c.beads.x = {9.505, 10.495};
    pair_forces(c.beads, c.pairs, c.cell, {}, c.material, c.dt);
    EXPECT_NEAR(c.pairs.sy[0], 0.5, 1e-9);
}

TEST(MindlinContact, LosesTangentialForceInProportionAsItUnloads) {
    EXPECT_DOUBLE_EQ(unloading_factor(0.5, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(unloading_factor(2.0, 1.0), 1.0);
    EXPECT_DOUBLE_EQ(unloading_factor(0.0, 1.0), 0.0);
    EXPECT_DOUBLE_EQ(overlap_at(Hertz::at(0.003, 5e4).elastic, 5e4), 0.003);
}
