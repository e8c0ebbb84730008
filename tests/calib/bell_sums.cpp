// Sums of Gaussian bells against their formula, term by term.
#include "calib/emulator/bell_sums.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pendular::calib_bell_sums_test {

TEST(BellSums, AreTheSumsOverAllPlaces) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (const std::size_t coordinates : {2u, 4u, 5u}) {
        const BellSums::Place inverse_squares = {0.7, 12, 2, 0.3, 1.4};
        BellSums sums(coordinates, inverse_squares);
        std::vector<std::pair<BellSums::Place, double>> known;
        for (int k = 0; k < 21; ++k) {  // two full blocks and a part of one
            BellSums::Place place;
            for (double& each : place) {
                each = normal(random);
            }
            const double weight = k == 7 ? 0 : normal(random);
            known.emplace_back(place, weight);
            sums.add(place, weight);
            const BellSums::Place at = {0.1, -0.4, k == 20 ? 80.0 : 0.2, 0.3, -0.1};
            std::array<double, 6> expected{};
            double size = 0;
            for (const auto& [z, w] : known) {
                double exponent = 0;
                for (std::size_t c = 0; c < coordinates; ++c) {
                    exponent -= inverse_squares[c] * (z[c] - at[c]) * (z[c] - at[c]) / 2;
                }
                const double term = w * std::exp(exponent);
                expected[0] += term;
                size += std::abs(term);
                for (std::size_t c = 0; c < coordinates; ++c) {
                    expected[1 + c] += term * (z[c] - at[c]);
                }
            }
            const auto found = sums.at(at);
            for (std::size_t c = 0; c < 6; ++c) {
                // A few roundings of each term, of differences up to 4.
                EXPECT_NEAR(found[c], expected[c], 1e-14 * size + 1e-280)
                    << coordinates << " " << c;
            }
        }
    }
}

TEST(BellSums, VanishWithoutPlacesAndFarFromAllPlaces) {
    BellSums sums(2, {1, 1});
    EXPECT_EQ(sums.at({})[0], 0);
    sums.add({1000, 0}, 5);
    EXPECT_LT(sums.at({})[0], 1e-300);
}

}  // namespace pendular::calib_bell_sums_test
