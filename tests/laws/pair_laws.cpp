// Laws that every state of the force loop obeys, on random states with fixed seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sim/dem/pair_forces.h"

using namespace pendular::dem;

namespace {

constexpr double modulus = 31622.8;  // stiffness number 1000

double sum_of(const std::vector<double>& values) {
    double total = 0;
    for (const double value : values) {
        total += value;
    }
    return total;
}

/// Overlapping beads with random velocities in a sheared cell, and their pairs.
struct State {
    Beads beads;
    Cell cell{7, 6, 8, 2.5};
    Pairs pairs;
    Flow flow{0.01, -0.002};
    Material material{.modulus = modulus, .friction = 0.3};
    double dt = 0.005;

    explicit State(unsigned seed, std::size_t count = 400) : beads(count) {
        std::mt19937_64 random(seed);
        std::uniform_real_distribution<double> at(0, 1), velocity(-0.1, 0.1);
        for (std::size_t i = 0; i < count; ++i) {
            beads.x[i] = cell.length * at(random), beads.y[i] = cell.height * at(random);
            beads.z[i] = cell.width * at(random);
            for (auto* v : {&beads.vx, &beads.vy, &beads.vz, &beads.wx, &beads.wy, &beads.wz}) {
                (*v)[i] = velocity(random);
            }
        }
        find();
    }
    void find() {
        pairs = find_pairs_by_brute_force(beads, cell, 1.0);
        while (pairs.size() % PairList::batch != 0) {
            pairs.add(0, 0, image_code::nowhere);
        }
    }
    PairSums forces() { return pair_forces(beads, pairs, cell, flow, material, dt); }
};

}  // namespace

TEST(PairForces, SumToZero) {
    State state(1);
    state.forces();
    double scale = 0;
    for (const double f : state.beads.fx) {
        scale = std::max(scale, std::abs(f));
    }
    ASSERT_GT(scale, 1);
    for (const auto* f : {&state.beads.fx, &state.beads.fy, &state.beads.fz}) {
        EXPECT_NEAR(sum_of(*f), 0, 1e-11 * scale * 400);
    }
}

TEST(PairForces, NeitherPushNorTurnBeadsThatTurnTogether) {
    // A rigid rotation of a touching pair about its contact normal's perpendicular axis moves no
    // surface against the other: no tangential force arises.
    State state(2, 2);
    state.beads = Beads(2);
    state.flow = {};
    state.cell = {10, 10, 10, 0};
    state.beads.x = {5, 5.99};
    state.beads.y = {5, 5};
    state.beads.z = {5, 5};
    const double rate = 0.2;  // about z through the contact: v = omega x r
    state.beads.vy = {-rate * 0.495, rate * 0.495};
    state.beads.wz = {rate, rate};
    state.find();
    state.forces();
    EXPECT_NEAR(state.beads.fy[0], 0, 1e-12);
    EXPECT_NEAR(state.beads.tz[0], 0, 1e-12);
    EXPECT_LT(state.beads.fx[0], -1);  // it is a contact
}

TEST(PairForces, DoNotDependOnWhichImagesTheBeadsAreWrittenIn) {
    State here(3), there(3);
    for (std::size_t i = 0; i < there.beads.size(); i += 3) {
        // One lattice vector up: the cell is sheared, so the image is shifted along the flow too.
        there.beads.x[i] += there.cell.offset, there.beads.y[i] += there.cell.height;
    }
    there.find();
    const PairSums a = here.forces(), b = there.forces();
    ASSERT_GT(a.largest_overlap, 0.01);
    for (std::size_t i = 0; i < here.beads.size(); ++i) {
        EXPECT_NEAR(here.beads.fx[i], there.beads.fx[i], 1e-7);
        EXPECT_NEAR(here.beads.tz[i], there.beads.tz[i], 1e-7);
    }
    EXPECT_NEAR(a.virial_12, b.virial_12, 1e-6 * std::abs(a.virial_22));
}

TEST(PairForces, MirrorWithTheSample) {
    // The mirror x -> -x, z -> -z is a rotation by pi about y; shear along x changes sign with it.
    State here(4), there(4);
    for (std::size_t i = 0; i < there.beads.size(); ++i) {
        there.beads.x[i] = -here.beads.x[i], there.beads.z[i] = -here.beads.z[i];
        there.beads.vx[i] = -here.beads.vx[i], there.beads.vz[i] = -here.beads.vz[i];
        there.beads.wx[i] = -here.beads.wx[i], there.beads.wz[i] = -here.beads.wz[i];
    }
    there.cell.offset = -here.cell.offset;
    there.flow.shear_rate = -here.flow.shear_rate;
    there.find();
    const PairSums a = here.forces(), b = there.forces();
    for (std::size_t i = 0; i < here.beads.size(); ++i) {
        EXPECT_NEAR(here.beads.fx[i], -there.beads.fx[i], 1e-7);
        EXPECT_NEAR(here.beads.fy[i], there.beads.fy[i], 1e-7);
        EXPECT_NEAR(here.beads.ty[i], there.beads.ty[i], 1e-7);
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
        const double x = state.beads.x[j] - state.beads.x[i] + n.n1 * state.cell.length +
                         n.n2 * state.cell.offset;
        const double y = state.beads.y[j] - state.beads.y[i] + n.n2 * state.cell.height;
        const double z = state.beads.z[j] - state.beads.z[i] + n.n3 * state.cell.width;
        const double force = std::hypot(state.pairs.sx[k], state.pairs.sy[k], state.pairs.sz[k]);
        EXPECT_NEAR(x * state.pairs.sx[k] + y * state.pairs.sy[k] + z * state.pairs.sz[k], 0,
                    1e-10 * (1 + force));
    }
}
