// Laws that every state of the force loop obeys, on random states with fixed seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/dem/pair_forces.h"

namespace pair_laws_test {

using namespace pendular::dem;

constexpr double modulus = 31622.8;  // stiffness number 1000

/// Overlapping grains with random velocities in a sheared cell, and their pairs.
struct State {
    Grains grains;
    Cell cell{7, 6, 8, 2.5};
    Pairs pairs;
    Flow flow{0.01, -0.002};
    Material material{.modulus = modulus, .friction = 0.3};
    double dt = 0.005;

    explicit State(unsigned seed, std::size_t count = 400) : grains(count) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> at(0, 1), velocity(-0.1, 0.1);
        for (std::size_t i = 0; i < count; ++i) {
            grains.position(i)[0] = cell.length * at(random),
            grains.position(i)[1] = cell.height * at(random);
            grains.position(i)[2] = cell.width * at(random);
            for (std::size_t d = 0; d < 3; ++d) {
                grains.velocity(i)[d] = velocity(random),
                grains.angular_velocity(i)[d] = velocity(random);
            }
        }
        find();
    }
    void find() {
        pairs = Pairs(find_pairs_by_brute_force(grains, cell, 0.0));
        pairs.fill_up(PairList::batch);
    }
    PairSums forces() { return pair_forces(grains, pairs, {cell, flow, material, {}, dt}); }
};

TEST(PairForces, SumToZero) {
    State state(1);
    state.forces();
    double scale = 0;
    Vector sum;
    for (const auto& load : state.grains.net_force) {
        scale = std::max(scale, std::abs(load.force[0]));
        sum += load.force;
    }
    ASSERT_GT(scale, 1);
    for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(sum[d], 0, 1e-11 * scale * 400);
    }
}

TEST(PairForces, NeitherPushNorTurnBeadsThatTurnTogether) {
    // A rigid rotation of a touching pair about its contact normal's perpendicular axis moves no
    // surface against the other: no tangential force arises.
    State state(2, 2);
    state.grains = Grains(2);
    state.flow = {};
    state.cell = {10, 10, 10, 0};
    state.grains.position(0)[0] = 5, state.grains.position(1)[0] = 5.99;
    state.grains.position(0)[1] = 5, state.grains.position(1)[1] = 5;
    state.grains.position(0)[2] = 5, state.grains.position(1)[2] = 5;
    const double rate = 0.2;  // about z through the contact: v = omega x r
    state.grains.velocity(0)[1] = -rate * 0.495, state.grains.velocity(1)[1] = rate * 0.495;
    state.grains.angular_velocity(0)[2] = rate, state.grains.angular_velocity(1)[2] = rate;
    state.find();
    state.forces();
    EXPECT_NEAR(state.grains.force(0)[1], 0, 1e-12);
    EXPECT_NEAR(state.grains.torque(0)[2], 0, 1e-12);
    EXPECT_LT(state.grains.force(0)[0], -1);  // it is a contact
}

TEST(PairForces, DoNotDependOnWhichImagesTheBeadsAreWrittenIn) {
    State here(3), there(3);
    for (std::size_t i = 0; i < there.grains.size(); i += 3) {
        // One lattice vector up: the cell is sheared, so the image is shifted along the flow too.
        there.grains.position(i)[0] += there.cell.offset,
            there.grains.position(i)[1] += there.cell.height;
    }
    there.find();
    const PairSums a = here.forces(), b = there.forces();
    ASSERT_GT(a.largest_overlap, 0.01);
    for (std::size_t i = 0; i < here.grains.size(); ++i) {
        EXPECT_NEAR(here.grains.force(i)[0], there.grains.force(i)[0], 1e-7);
        EXPECT_NEAR(here.grains.torque(i)[2], there.grains.torque(i)[2], 1e-7);
    }
    EXPECT_NEAR(a.virial_12, b.virial_12, 1e-6 * std::abs(a.virial_22));
}

TEST(PairForces, MirrorWithTheSample) {
    // The mirror x -> -x, z -> -z is a rotation by pi about y; shear along x changes sign with it.
    State here(4), there(4);
    for (std::size_t i = 0; i < there.grains.size(); ++i) {
        there.grains.position(i)[0] = -here.grains.position(i)[0],
        there.grains.position(i)[2] = -here.grains.position(i)[2];
        there.grains.velocity(i)[0] = -here.grains.velocity(i)[0],
        there.grains.velocity(i)[2] = -here.grains.velocity(i)[2];
        there.grains.angular_velocity(i)[0] = -here.grains.angular_velocity(i)[0],
        there.grains.angular_velocity(i)[2] = -here.grains.angular_velocity(i)[2];
    }
    there.cell.offset = -here.cell.offset;
    there.flow.shear_rate = -here.flow.shear_rate;
    there.find();
    const PairSums a = here.forces(), b = there.forces();
    for (std::size_t i = 0; i < here.grains.size(); ++i) {
        EXPECT_NEAR(here.grains.force(i)[0], -there.grains.force(i)[0], 1e-7);
        EXPECT_NEAR(here.grains.force(i)[1], there.grains.force(i)[1], 1e-7);
        EXPECT_NEAR(here.grains.torque(i)[1], there.grains.torque(i)[1], 1e-7);
    }
    EXPECT_NEAR(a.virial_12, -b.virial_12, 1e-6 * std::abs(a.virial_22));
}

TEST(PairForces, ObeyTheCoulombLimitOnTheElasticForce) {
    State state(5);
    for (int step = 0; step < 50; ++step) {
        state.forces();  // positions stay: tangential forces grow until they slide
    }
    int sliding = 0;
    for (std::size_t k = 0; k < state.pairs.size(); ++k) {
        const double h = state.pairs.root[k] * state.pairs.root[k];
        const double limit = 0.3 * Hertz::at(h, modulus).elastic;
        const double force = std::hypot(state.pairs.sx[k], state.pairs.sy[k], state.pairs.sz[k]);
        EXPECT_LE(force, limit * (1 + 1e-12));
        sliding += limit > 0 && force > limit * (1 - 1e-9);
    }
    EXPECT_GT(sliding, 20);
}

TEST(PairForces, AreTangentialWhereTheyAreRemembered) {
    State state(6);
    state.forces(), state.forces();
    for (std::size_t k = 0; k < state.pairs.size(); ++k) {
        if (state.pairs.root[k] <= 0) {
            continue;
        }
        const auto i = state.pairs.first[k], j = state.pairs.second[k];
        const Image n = image_code::image(state.pairs.image[k]);
        const double x = state.grains.position(j)[0] - state.grains.position(i)[0] +
                         n.n1 * state.cell.length + n.n2 * state.cell.offset;
        const double y =
            state.grains.position(j)[1] - state.grains.position(i)[1] + n.n2 * state.cell.height;
        const double z =
            state.grains.position(j)[2] - state.grains.position(i)[2] + n.n3 * state.cell.width;
        const double force = std::hypot(state.pairs.sx[k], state.pairs.sy[k], state.pairs.sz[k]);
        EXPECT_NEAR(x * state.pairs.sx[k] + y * state.pairs.sy[k] + z * state.pairs.sz[k], 0,
                    1e-10 * (1 + force));
    }
}

TEST(PairForces, LeaveAngularMomentumAlone) {
    // A cluster far from its images: what the forces turn about the origin the torques turn back.
    State state(7);
    state.cell = {60, 60, 60, 0};
    state.find();
    state.forces(), state.forces();  // the second with tangential forces to unload and to turn
    Vector turning;
    double scale = 0;
    for (std::size_t i = 0; i < state.grains.size(); ++i) {
        const Vector &r = state.grains.position(i), &f = state.grains.force(i);
        turning += Vector(r[1] * f[2] - r[2] * f[1], r[2] * f[0] - r[0] * f[2],
                          r[0] * f[1] - r[1] * f[0]) +
                   state.grains.torque(i);
        scale = std::max(scale, std::abs(state.grains.torque(i)[2]));
    }
    ASSERT_GT(scale, 1);
    for (std::size_t d = 0; d < 3; ++d) {
        EXPECT_NEAR(turning[d], 0, 1e-7 * scale);
    }
}

}  // namespace pair_laws_test
