// The law of the inertial number, fitted with its exponent.
#include "tests/sim/inertial_law_fit.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace pendular::sim_inertial_law_test {

using closures::fit_inertial_law;
using closures::InertialLaw;
using closures::InertialPoint;

constexpr double numbers[] = {0.001, 0.003, 0.01, 0.03, 0.1};

std::vector<InertialPoint> points(double limit, double amplitude, double exponent, double error,
                                  std::mt19937* random = nullptr) {
    std::vector<InertialPoint> points;
    std::normal_distribution<double> normal(0, error);
    for (const double number : numbers) {
        points.push_back(
            {number,
             limit + amplitude * std::pow(number, exponent) + (random ? normal(*random) : 0),
             error});
    }
    return points;
}

TEST(InertialLaw, FindsThePlantedExponent) {
    for (const double exponent : {0.4, 0.75, 1.2}) {
        const InertialLaw law = fit_inertial_law(points(0.1, 0.5, exponent, 0.002));
        EXPECT_NEAR(law.exponent.value, exponent, 1e-4);
        EXPECT_NEAR(law.limit.value, 0.1, 1e-5);
        EXPECT_NEAR(law.amplitude.value, 0.5, 1e-3);
        EXPECT_NEAR(law.chi2, 0, 1e-5);
        EXPECT_EQ(law.dof, 2);
    }
}

// 400 draws determine a standard deviation to 3.5 %; the law is not linear in its exponent.
TEST(InertialLaw, StatesTheScatterOfItsLimit) {
    std::mt19937 random(5);
    double sum = 0, squares = 0, stated = 0;
    constexpr int draws = 400;
    for (int k = 0; k < draws; ++k) {
        const InertialLaw law = fit_inertial_law(points(0.09, 0.5, 0.4, 0.002, &random));
        sum += law.limit.value, squares += std::pow(law.limit.value - 0.09, 2);
        stated += law.limit.standard_error / draws;
    }
    EXPECT_NEAR(std::sqrt(squares / draws) / stated, 1, 0.15);
    EXPECT_NEAR(sum / draws, 0.09, 0.25 * stated);
    // A given exponent would claim a tenth of a percent too much: it is the exponent that counts.
    EXPECT_GT(stated, 0.003);
}

TEST(InertialLaw, NeedsThreeInertialNumbers) {
    std::vector<InertialPoint> few = points(0.1, 0.5, 1, 0.002);
    few.resize(3);
    EXPECT_THROW(fit_inertial_law(few), std::invalid_argument);
    EXPECT_THROW(fit_inertial_law({{0.1, 1, 1}, {0.1, 1, 1}, {0.2, 1, 1}, {0.2, 1, 1}}),
                 std::invalid_argument);
}

}  // namespace pendular::sim_inertial_law_test
