// Face-centred cubic crystals: every grain does the same, so that stresses have closed forms.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "sim/dem/shear_cell.h"

namespace crystals_test {

using namespace pendular;
using namespace pendular::dem;

constexpr int cells = 3;  ///< cubic cells per direction, of four grains each

/// A crystal whose cubic cell has these edges, its cube axes along the directions.
Sample crystal(const std::array<double, 3>& edge) {
    constexpr double within[4][3] = {
        {0.25, 0.25, 0.25}, {0.75, 0.75, 0.25}, {0.75, 0.25, 0.75}, {0.25, 0.75, 0.75}};
    Sample sample{Grains(4 * cells * cells * cells),
                  {cells * edge[0], cells * edge[1], cells * edge[2], 0}};
    for (std::size_t i = 0; i < sample.grains.size(); ++i) {
        const std::size_t cell = i / 4;
        sample.grains.position(i) = {
            edge[0] * (static_cast<double>(cell % cells) + within[i % 4][0]),
            edge[1] * (static_cast<double>(cell / cells % cells) + within[i % 4][1]),
            edge[2] * (static_cast<double>(cell / cells / cells) + within[i % 4][2])};
    }
    return sample;
}

/// Normal stresses of a crystal at rest: each grain has two contacts, counted once, in each of the
/// planes of its cube axes, along the planes' diagonals; four grains share the volume of a cubic
/// cell.
std::array<double, 3> normal_stresses(const std::array<double, 3>& edge, double modulus,
                                      double attraction) {
    std::array<double, 3> stress{};
    for (int plane = 0; plane < 3; ++plane) {
        const int a = (plane + 1) % 3, b = (plane + 2) % 3;
        const double distance = 0.5 * std::hypot(edge[a], edge[b]);
        if (distance >= 1) {
            continue;
        }
        const double force = modulus / 3 * std::pow(1 - distance, 1.5) - attraction;
        const double density = 4 * 2 / (edge[0] * edge[1] * edge[2]);
        for (const int d : {a, b}) {
            stress[d] += density * force / distance * edge[d] * edge[d] / 4;
        }
    }
    return stress;
}

/// Stress ratio s1/s3 of a crystal held at s1 along its vertical cube axis, while it is widened
/// alike in both other directions: at its largest, and when the crystal has been widened by `end`.
struct Triaxial {
    double largest = 0, last = 0;
};
Triaxial widen(double friction, double end, double rate) {
    const double stiffness_number = 1e5, modulus = std::pow(stiffness_number, 1.5);
    // Isotropic at stress 1: sqrt(8) F over the squared distance, which is all but 1.
    const double distance = 1 - overlap_at(1 / std::sqrt(8.0), modulus);
    const double edge = std::sqrt(2.0) * distance;
    ShearCell sample(crystal({edge, edge, edge}), {.modulus = modulus, .friction = friction},
                     {.length_rate = rate, .width_rate = rate});
    // Twelve equally stiff contacts per grain, damped nearly critically: at the standard time step
    // the explicit damping of the fastest mode overshoots.
    sample.set_time_step_fraction(0.1);
    sample.hold_normal_stress(true);
    Triaxial result;
    const double begin = sample.cell().length;
    while (sample.cell().length < begin * (1 + end)) {
        sample.step();
        const Stress& s = sample.stress();
        result.last = s.s22 / (0.5 * (s.s11 + s.s33));
        result.largest = std::max(result.largest, result.last);
    }
    return result;
}

TEST(Crystal, HasTheStressesOfItsContactsAlongItsThreeAxes) {
    const double modulus = std::pow(1000.0, 1.5), edge = std::sqrt(2.0);
    for (const auto& strain : {std::array{0.01, 0.01, 0.01}, std::array{0.001, 0.02, 0.001},
                               std::array{-0.004, 0.02, 0.006}, std::array{0.03, -0.02, -0.02}}) {
        for (const double pull_off : {0.0, 2.0}) {
            const std::array<double, 3> edges = {edge * (1 - strain[0]), edge * (1 - strain[1]),
                                                 edge * (1 - strain[2])};
            const BridgeLaw wet({.reduced_pressure = 0.5, .bridge_volume = 1e-3});
            ShearCell sample(crystal(edges), {.modulus = modulus}, Flow{},
                             pull_off > 0 ? wet : BridgeLaw());
            sample.let_bridges_form(pull_off > 0);
            sample.step();
            const auto expected = normal_stresses(edges, modulus, pull_off);
            const Stress& s = sample.stress();
            EXPECT_NEAR(s.s11, expected[0], 1e-9 * std::abs(expected[0]));
            EXPECT_NEAR(s.s22, expected[1], 1e-9 * std::abs(expected[1]));
            EXPECT_NEAR(s.s33, expected[2], 1e-9 * std::abs(expected[2]));
            EXPECT_NEAR(s.s12, 0, 1e-9 * std::abs(expected[1]));
            ASSERT_GT(std::abs(expected[0] - expected[1]), strain[0] == strain[1] ? -1 : 1);
        }
    }
}

class CrystalTriaxial : public testing::TestWithParam<double> {};

TEST_P(CrystalTriaxial, YieldsAtTheStressRatioOfRigidFrictionalSpheres) {
    // Widening opens the four contacts of a grain in the horizontal plane; the other eight, at 45
    // degrees, slide with F_T = mu F_N, which helps to carry the vertical stress: each contact
    // gives (1 + mu) F_N/2 to s1 and, every other one, (1 - mu) F_N/2 to either s3. Hence
    //     s1/s3 = 2 (1 + mu)/(1 - mu).            Thornton, Geotechnique 29 (1979) 441
    const double friction = GetParam();
    const double expected = 2 * (1 + friction) / (1 - friction);
    // Widened by 1.2e-5, as much as the overlaps, all of this has happened; beyond that grains of
    // friction 0.3 begin to roll. The rates leave 0.1 % of viscous forces.
    const Triaxial found = widen(friction, 1.2e-5, 1e-5);
    std::printf("friction %.1f: s1/s3 = %.4f, at its largest %.4f, %.4f expected\n", friction,
                found.last, found.largest, expected);
    EXPECT_NEAR(found.last, expected, 0.001 * expected);
    EXPECT_NEAR(found.largest, expected, 0.01 * expected);
}

INSTANTIATE_TEST_SUITE_P(Frictions, CrystalTriaxial, testing::Values(0.0, 0.1, 0.3));

}  // namespace crystals_test
