#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "sim/dem/fields.h"
#include "sim/dem/structure.h"

namespace sim_structure_test {

using namespace pendular::dem;

/// One grain in the middle with contacts along the given directions.
Structure around_one_grain(const std::vector<std::array<double, 3>>& directions) {
    Grains grains(directions.size() + 1);
    Pairs pairs;
    grains.position(0)[0] = grains.position(0)[1] = grains.position(0)[2] = 50;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        const auto& [x, y, z] = directions[k];
        const double length = std::hypot(x, y, z);
        grains.position(k + 1)[0] = 50 + x / length, grains.position(k + 1)[1] = 50 + y / length,
                            grains.position(k + 1)[2] = 50 + z / length;
        pairs.add(0, static_cast<std::int32_t>(k + 1),
                  static_cast<std::uint8_t>(image_code::of({})));
        pairs.root.back() = 0.05;
    }
    return structure_of(grains, {100, 100, 100, 0}, pairs, {}, {.modulus = 3e4}, {});
}

std::vector<std::array<double, 3>> fcc() {
    std::vector<std::array<double, 3>> directions;
    for (const double a : {-1.0, 1.0}) {
        for (const double b : {-1.0, 1.0}) {
            directions.push_back({a, b, 0});
            directions.push_back({a, 0, b});
            directions.push_back({0, a, b});
        }
    }
    return directions;
}

TEST(BondOrder, IsThatOfTheFccAndHcpLattices) {
    // Steinhardt, Nelson and Ronchetti (1983): Q6 = 0.57452 for fcc, 0.48476 for hcp.
    EXPECT_NEAR(around_one_grain(fcc()).bond_order, 0.57452, 1e-5);
    std::vector<std::array<double, 3>> hcp;
    for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3;
        hcp.push_back({std::cos(angle), std::sin(angle), 0});
    }
    for (int k = 0; k < 3; ++k) {
        const double angle = std::numbers::pi / 6 + k * 2 * std::numbers::pi / 3;
        for (const double up : {-1.0, 1.0}) {
            hcp.push_back({std::cos(angle) / std::sqrt(3.0), std::sin(angle) / std::sqrt(3.0),
                           up * std::sqrt(2.0 / 3)});
        }
    }
    EXPECT_NEAR(around_one_grain(hcp).bond_order, 0.48476, 1e-5);
}

TEST(BondOrder, DoesNotChangeWhenTheLatticeTurns) {
    auto turned = fcc();
    for (auto& [x, y, z] : turned) {
        const double c = std::cos(0.7), s = std::sin(0.7);
        const std::array<double, 3> about_z = {c * x - s * y, s * x + c * y, z};
        x = about_z[0], y = c * about_z[1] - s * about_z[2], z = s * about_z[1] + c * about_z[2];
    }
    EXPECT_NEAR(around_one_grain(turned).bond_order, 0.57452, 1e-5);
}

TEST(BondOrder, VanishesForRandomDirections) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::vector<std::array<double, 3>> directions(4000);
    for (auto& d : directions) {
        d = {normal(random), normal(random), normal(random)};
    }
    EXPECT_LT(around_one_grain(directions).bond_order, 0.04);  // 1/sqrt(4000) = 0.016 expected
}

TEST(Structure, CountsContactsFromBothSidesAndSignsTheFabric) {
    const Structure s = around_one_grain({{1, 1, 0}, {1, -1, 0}, {1, -2, 0}});
    EXPECT_DOUBLE_EQ(s.contact_coordination, 2 * 3 / 4.0);
    EXPECT_NEAR(s.fabric_12_contact, (0.5 - 0.5 - 0.4) / 3, 1e-12);
    EXPECT_NEAR(s.overlap, 0.0025, 1e-12);
}

TEST(Localization, IsZeroForUniformShearAndOneForAThinBand) {
    const double height = 20, rate = 0.1;
    Grains uniform(2000), band(2000);
    for (std::size_t i = 0; i < 2000; ++i) {
        const double y = height * (static_cast<double>(i) + 0.5) / 2000;
        uniform.position(i)[1] = band.position(i)[1] = y;
        // Two blocks that slide on one another at mid-height: v1 = +-rate H/2, peculiar v1 - rate
        // x2.
        band.velocity(i)[0] =
            (y < height / 2 ? -1 : 1) * rate * height / 2 - rate * (y - height / 2);
    }
    MotionProfile flat(20), sharp(20);
    flat.add(uniform, height);
    sharp.add(band, height);
    EXPECT_DOUBLE_EQ(flat.localization(height, rate), 0);
    EXPECT_NEAR(sharp.localization(height, rate), 1,
                0.01);  // bins of one diameter smear it a little
}

}  // namespace sim_structure_test
