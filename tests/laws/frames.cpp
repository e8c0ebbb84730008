// Whole samples in steady shear, wet and dry: their motion does not depend on where they lie, in
// which images and by which numbers their grains are written, or on how the work is divided. All
// agree to rounding, 1e-9 of the largest value over 200 steps, until chaos parts them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include "sim/dem/shear_cell.h"

namespace frames_test {

using namespace pendular::dem;

constexpr int count = 400;
constexpr double shear_rate = 0.1;
const Material material{.modulus = 5e3, .friction = 0.3};
const BridgeLaw bridges({.reduced_pressure = 1, .bridge_volume = 4e-3});

/// A sample that has been sheared for a while; contacts are not remembered.
const Sample& flowing() {
    static const Sample sample = [] {
        ShearCell cell(count, material, shear_rate, 21, bridges);
        EXPECT_TRUE(cell.compress());
        while (cell.strain() < 0.7) {
            cell.step();
        }
        Sample result{cell.grains(), cell.cell()};
        std::iota(result.grains.number.begin(), result.grains.number.end(), 0);
        return result;
    }();
    return sample;
}

/// Shears a sample on.
ShearCell sheared(const Sample& sample, bool wet, int steps = 200, double rate = shear_rate,
                  int parts = 1, EnergyAccounting accounting = EnergyAccounting::off) {
    ShearCell cell(sample, material, {.shear_rate = rate}, wet ? bridges : BridgeLaw(), parts);
    cell.hold_normal_stress(true);
    cell.let_bridges_form(wet);
    for (int step = 0; step < steps; ++step) {
        cell.step(accounting);
    }
    return cell;
}

/// Motion of a grain, by its first number.
struct State {
    std::vector<Vector> velocity, angular_velocity, force, torque;

    explicit State(const ShearCell& cell) {
        const Grains& grains = cell.grains();
        for (auto* all : {&velocity, &angular_velocity, &force, &torque}) {
            all->resize(grains.size());
        }
        for (std::size_t i = 0; i < grains.size(); ++i) {
            const auto n = static_cast<std::size_t>(grains.number[i]);
            velocity[n] = grains.velocity(i), angular_velocity[n] = grains.angular_velocity(i);
            force[n] = grains.force(i), torque[n] = grains.torque(i);
        }
    }
    static constexpr std::vector<Vector> State::*members[] = {
        &State::velocity, &State::angular_velocity, &State::force, &State::torque};
};

/// Largest difference of any component of any grain over the largest component, for states of which
/// the second is seen in the mirror `sign` and calls grain i `name[i]`.
double difference(const State& a, const State& b, const Vector& sign = {1, 1, 1},
                  const std::vector<std::int32_t>& name = {}) {
    double worst = 0;
    for (const auto member : State::members) {
        double scale = 0, apart = 0;
        for (std::size_t i = 0; i < (a.*member).size(); ++i) {
            const Vector& mine = (a.*member)[i];
            const Vector other =
                sign * (b.*member)[name.empty() ? i : static_cast<std::size_t>(name[i])];
            for (std::size_t d = 0; d < 3; ++d) {
                scale = std::max(scale, std::abs(mine[d]));
                apart = std::max(apart, std::abs(mine[d] - other[d]));
            }
        }
        worst = std::max(worst, apart / scale);
    }
    return worst;
}

class Frames : public testing::TestWithParam<bool> {
  protected:
    const bool wet = GetParam();
    const State here{sheared(flowing(), wet)};
};

TEST_P(Frames, AShiftedSampleMovesAlike) {
    Sample shifted = flowing();
    for (auto& grain : shifted.grains.motion) {
        grain.position += Vector(0.37, 1.21, -2.03);
    }
    EXPECT_LT(difference(here, State(sheared(shifted, wet))), 1e-9);
}

TEST_P(Frames, ImagesOfItsBeadsMoveAlike) {
    Sample written = flowing();
    const Cell& cell = written.cell;
    for (std::size_t i = 0; i < written.grains.size(); ++i) {
        const Image image{static_cast<int>(i % 3) - 1, static_cast<int>(i / 3 % 3) - 1,
                          static_cast<int>(i / 9 % 3) - 1};
        written.grains.position(i) += image.shift(cell);
    }
    EXPECT_LT(difference(here, State(sheared(written, wet))), 1e-9);
}

TEST_P(Frames, TheLatticeByAnotherOffsetMovesAlike) {
    // Offsets that differ by the length describe the same lattice.
    Sample written = flowing();
    written.cell.offset += written.cell.length;
    EXPECT_LT(difference(here, State(sheared(written, wet))), 1e-9);
}

TEST_P(Frames, ASampleTurnedHalfRoundMovesAlike) {
    // (x, y, z) -> (-x, y, -z) is a rotation by pi: vectors and angular velocities turn alike, the
    // shear is reversed.
    const Vector turn(-1, 1, -1);
    Sample turned = flowing();
    turned.cell.offset = -turned.cell.offset;
    for (auto& grain : turned.grains.motion) {
        grain = {turn * grain.position, turn * grain.velocity, turn * grain.angular_velocity};
    }
    const ShearCell there = sheared(turned, wet, 200, -shear_rate);
    EXPECT_LT(difference(here, State(there), turn), 1e-9);
    EXPECT_GT(there.stress().s12, 0.1);
}

TEST_P(Frames, ASampleInTheMirrorMovesAlike) {
    // z -> -z leaves the shear as it is; angular velocities, axial, keep their z and turn their x
    // and y.
    Sample mirrored = flowing();
    for (auto& grain : mirrored.grains.motion) {
        grain.position = Vector(1, 1, -1) * grain.position;
        grain.velocity = Vector(1, 1, -1) * grain.velocity;
        grain.angular_velocity = Vector(-1, -1, 1) * grain.angular_velocity;
    }
    State there(sheared(mirrored, wet));
    for (auto* axial : {&there.angular_velocity, &there.torque}) {
        for (Vector& v : *axial) {
            v = -v;
        }
    }
    EXPECT_LT(difference(here, there, {1, 1, -1}), 1e-9);
}

TEST_P(Frames, BeadsByOtherNumbersMoveAlike) {
    Sample permuted = flowing();
    std::vector<std::int32_t> name(count);
    std::iota(name.begin(), name.end(), 0);
    std::mt19937_64 random(31);
    std::ranges::shuffle(name, random);
    for (std::size_t i = 0; i < permuted.grains.size(); ++i) {
        permuted.grains.motion[static_cast<std::size_t>(name[i])] = flowing().grains.motion[i];
    }
    EXPECT_LT(difference(here, State(sheared(permuted, wet)), {1, 1, 1}, name), 1e-9);
}

TEST_P(Frames, TwoPartsMoveAlikeToRounding) {
    const State one(sheared(flowing(), wet, 100)), two(sheared(flowing(), wet, 100, shear_rate, 2));
    EXPECT_LT(difference(one, two), 1e-10);
}

TEST_P(Frames, EnergyAccountingChangesNotABit) {
    const State accounted(sheared(flowing(), wet, 200, shear_rate, 1, EnergyAccounting::on));
    EXPECT_EQ(difference(here, accounted), 0);
}

INSTANTIATE_TEST_SUITE_P(Samples, Frames, testing::Bool(), [](const auto& sample) {
    return sample.param ? std::string("Wet") : std::string("Dry");
});

TEST(Repetition, GivesTheSameBitsForTheSameSeedAndNumberOfParts) {
    const auto from_seed = [] {
        ShearCell cell(count, material, shear_rate, 8, bridges);
        EXPECT_TRUE(cell.compress());
        while (cell.strain() < 1) {
            cell.step();
        }
        return State(cell);
    };
    EXPECT_EQ(difference(from_seed(), from_seed()), 0);
    const auto in_parts = [] { return State(sheared(flowing(), true, 100, shear_rate, 2)); };
    EXPECT_EQ(difference(in_parts(), in_parts()), 0);
}

TEST(Repetition, OfAnotherSeedIsAnotherSample) {
    const Sample a = random_gas(count, 1), b = random_gas(count, 2);
    EXPECT_NE(a.grains.position(0), b.grains.position(0));
}

TEST(Momentum, IsKeptByWetSamplesWhateverTheirParts) {
    // The flow's own term -L v acts on the sum as well, which stays zero from rest.
    const auto expect_none = [](const ShearCell& cell) {
        Vector sum;
        double largest = 0;
        for (const auto& grain : cell.grains().motion) {
            sum += grain.velocity;
            largest = std::max(largest, std::abs(grain.velocity[0]));
        }
        ASSERT_GT(largest, 0.1);
        for (std::size_t d = 0; d < 3; ++d) {
            EXPECT_NEAR(sum[d], 0, 1e-9);
        }
    };
    expect_none(sheared(flowing(), true, 2000));
    expect_none(sheared(flowing(), true, 100, shear_rate, 2));
}

}  // namespace frames_test
