// Two grains meet: the contact law against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/dem/pair_forces.h"

namespace sim_contact_test {

using namespace pendular::dem;

/// Two grains approaching along x in a large, resting cell.
struct Collision {
    Grains grains{2};
    Cell cell{20, 20, 20, 0};
    Pairs pairs;
    Material material;
    double dt, time = 0, contact_time = 0;

    Collision(double modulus, double damping, double approach, double step) : dt(step) {
        material = {.modulus = modulus, .friction = 0, .damping = damping};
        grains.position(0)[0] = 9, grains.position(1)[0] = 10.001, grains.position(0)[1] = 10,
        grains.position(1)[1] = 10, grains.position(0)[2] = 10, grains.position(1)[2] = 10;
        grains.velocity(0)[0] = approach / 2, grains.velocity(1)[0] = -approach / 2;
        pairs = Pairs(find_pairs_by_brute_force(grains, cell, 0.5));
        pairs.fill_up(PairList::batch);
    }
    double separation_speed() const { return grains.velocity(1)[0] - grains.velocity(0)[0]; }
    void forces() { pair_forces(grains, pairs, {cell, {}, material, {}, dt}); }
    void step() {
        forces();
        for (int i = 0; i < 2; ++i) {
            grains.velocity(i)[0] += dt * grains.force(i)[0];
            grains.position(i)[0] += dt * grains.velocity(i)[0];
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
    // From zeta = sqrt(5/6) = 0.913 on the dashpot does not let the grains rebound.
    Collision collision(1e5, 0.98, 0.1, 2e-6);
    while (collision.time < 0.5) {
        collision.step();
    }
    EXPECT_LT(collision.separation_speed(), 1e-3);
}

TEST(MindlinContact, SlidesAtTheCoulombLimitAndSpinsTheBeadsUp) {
    // Pressed together and dragged past one another: the elastic normal force is that of the
    // overlap, the tangential force mu times it, and both grains turn the same way.
    Collision c(1e5, 0.98, 0, 1e-5);
    c.material.friction = 0.2;
    c.grains.position(0)[0] = 9.5, c.grains.position(1)[0] = 10.49;
    c.grains.velocity(0)[0] = 0, c.grains.velocity(1)[0] = 0;
    c.grains.velocity(0)[1] = -1, c.grains.velocity(1)[1] = 1;
    for (int step = 0; step < 200; ++step) {
        c.forces();
    }
    const double elastic = Hertz::at(0.01, 1e5).elastic;
    EXPECT_NEAR(c.grains.force(1)[1], -0.2 * elastic, 1e-9 * elastic);
    EXPECT_NEAR(c.grains.force(1)[0], elastic, 1e-9 * elastic);
    EXPECT_NEAR(c.grains.torque(0)[2], c.grains.torque(1)[2], 1e-12);
    EXPECT_NEAR(c.grains.torque(1)[2], 0.495 * 0.2 * elastic, 1e-9 * elastic);
}

TEST(MindlinContact, IsAsStiffAsTheRatioOfMindlinSays) {
    // Before it slides, K_T = K_N (2 - 2 nu)/(2 - nu) times the tangential displacement.
    Collision c(1e5, 0, 0, 1e-4);
    c.material.friction = 10;
    c.grains.position(0)[0] = 9.5, c.grains.position(1)[0] = 10.49;
    c.grains.velocity(0)[0] = 0, c.grains.velocity(1)[0] = 0;
    c.grains.velocity(0)[2] = 0, c.grains.velocity(1)[2] = 0.001;
    for (int step = 0; step < 10; ++step) {
        c.forces();
    }
    const double stiffness = Hertz::at(0.01, 1e5).normal_stiffness * (2 - 0.6) / (2 - 0.3);
    EXPECT_NEAR(c.grains.force(1)[2], -stiffness * 10 * 1e-4 * 0.001, 1e-6 * stiffness * 1e-6);
}

/// A pair at rest, overlapping by 0.01 along x, that remembers a tangential force of (0, 1, 0).
Collision stuck_pair(double step) {
    Collision c(1e5, 0, 0, step);
    c.material.friction = 10;
    c.grains.position(0)[0] = 9.505, c.grains.position(1)[0] = 10.495;
    c.grains.velocity(0)[0] = 0, c.grains.velocity(1)[0] = 0;
    c.forces();  // into contact
    c.pairs.sy[0] = 1;
    return c;
}

TEST(MindlinContact, TurnsItsTangentialForceWithThePair) {
    // A rigid quarter turn about z: no surface moves against the other, and the remembered force
    // turns from +y to -x with the pair. Each step errs by (rate dt)^2.
    const int steps = 20000;
    const double angle = 0.5 * std::numbers::pi, rate = 1, dt = angle / rate / steps;
    Collision c = stuck_pair(dt);
    c.grains.angular_velocity(0)[2] = rate, c.grains.angular_velocity(1)[2] = rate;
    for (int step = 1; step <= steps; ++step) {
        const double phi = angle * step / steps, x = 0.495 * std::cos(phi),
                     y = 0.495 * std::sin(phi);
        c.grains.position(0)[0] = 10 - x, c.grains.position(1)[0] = 10 + x,
        c.grains.position(0)[1] = 10 - y, c.grains.position(1)[1] = 10 + y;
        c.grains.velocity(0)[0] = rate * y, c.grains.velocity(1)[0] = -rate * y,
        c.grains.velocity(0)[1] = -rate * x, c.grains.velocity(1)[1] = rate * x;
        c.forces();
    }
    EXPECT_NEAR(c.pairs.sx[0], -1, 1e-2);
    EXPECT_NEAR(c.pairs.sy[0], 0, 1e-2);
    EXPECT_NEAR(c.pairs.sz[0], 0, 1e-9);
}

TEST(MindlinContact, SpinsItsTangentialForceAboutItsNormal) {
    // Both grains angular velocity about the normal at the same rate: the force goes round with
    // them, from +y to +z after a quarter turn about x.
    const int steps = 20000;
    const double dt = 0.5 * std::numbers::pi / steps;
    Collision c = stuck_pair(dt);
    c.grains.angular_velocity(0)[0] = 1, c.grains.angular_velocity(1)[0] = 1;
    for (int step = 0; step < steps; ++step) {
        c.forces();
    }
    EXPECT_NEAR(c.pairs.sy[0], 0, 1e-2);
    EXPECT_NEAR(c.pairs.sz[0], 1, 1e-2);
}

TEST(MindlinContact, LosesTangentialForceInTheLoopAsItUnloads) {
    // From overlap 0.01 to 0.0025 K_T halves, and so does the force; back again it stays.
    Collision c = stuck_pair(1e-4);
    c.grains.position(0)[0] = 9.50125, c.grains.position(1)[0] = 10.49875;
    c.forces();
    EXPECT_NEAR(c.pairs.sy[0], 0.5, 1e-9);
    c.grains.position(0)[0] = 9.505, c.grains.position(1)[0] = 10.495;
    c.forces();
    EXPECT_NEAR(c.pairs.sy[0], 0.5, 1e-9);
}

TEST(MindlinContact, LosesTangentialForceInProportionAsItUnloads) {
    EXPECT_DOUBLE_EQ(unloading_factor(0.5, 1.0), 0.5);
    EXPECT_DOUBLE_EQ(unloading_factor(2.0, 1.0), 1.0);
    EXPECT_DOUBLE_EQ(unloading_factor(0.0, 1.0), 0.0);
    EXPECT_DOUBLE_EQ(overlap_at(Hertz::at(0.003, 5e4).elastic, 5e4), 0.003);
}

}  // namespace sim_contact_test
