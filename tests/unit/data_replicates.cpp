#include "data/replicates.h"

#include <cmath>
#include <numbers>

#include "tests/unit/data_support.h"

namespace pendular::data_replicates_test {

using testing::HasSubstr;
using testing::IsEmpty;

Reading reading(double normal_stress, double ratio, double fraction, double relative_error) {
    Reading result;
    result.condition = {normal_stress, 0.01, 0, std::nullopt};
    result.value = {ratio * normal_stress, fraction};
    const Eigen::Vector2d errors = relative_error * result.value;
    result.covariance = errors.cwiseProduct(errors).asDiagonal();
    return result;
}

/// By which the variance known from one pair is widened.
const double one_pair =
    std::pow(std::tan(std::numbers::pi * (0.5 * std::erfc(-std::sqrt(2.0)) - 0.5)) / 2, 2);

double relative_variance(const Reading& reading, int i) {
    return reading.covariance(i, i) / std::pow(reading.value(i), 2);
}

TEST(Replicates, AreTheSameConditionWithinTwoPercent) {
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0.01), reading(1015, 0.3, 0.6, 0.01),
                    reading(1030, 0.3, 0.6, 0.01), reading(1000, 0.3, 0.6, 0.01),
                    reading(1000, 0.3, 0.6, 0.01)};
    all.readings[3].condition.liquid_content = 0.03;
    all.readings[4].condition.inertial_number = 0.0103;
    pool_replicates(all);
    std::vector<int> counts;
    for (const Reading& each : all.readings)
        counts.push_back(each.replicates);
    EXPECT_THAT(counts, testing::ElementsAre(2, 2, 1, 1, 1));
}

TEST(Replicates, AreOfTheSameFilling) {
    Reading a = reading(1000, 0.3, 0.6, 0.01), b = a;
    a.condition.bead_volume = 60e-6;
    EXPECT_FALSE(are_replicates(a, b));  // of one it is not known
    b.condition.bead_volume = 60.5e-6;
    EXPECT_TRUE(are_replicates(a, b));
    b.condition.bead_volume = 30e-6;  // where the beads' weight counts for less
    EXPECT_FALSE(are_replicates(a, b));
}

TEST(Replicates, AddTheScatterTheirOwnErrorsDoNotExplain) {
    // Two replicates at +-2 % of the ratio: s_rep^2 = 2 x 2 %^2; errors of 1 % explain 1 %^2.
    // Equal set points; a third condition without replicates gets the same excess. One pair:
    // Student's t with one degree of freedom has 95.45 % within 13.97 (its quantile is
    // tan(pi (p - 1/2))), in place of 2.
    Measurements all;
    all.readings = {reading(1000, 0.3 * 0.98, 0.6, 0.01), reading(1000, 0.3 * 1.02, 0.6, 0.01),
                    reading(3000, 0.3, 0.6, 0.01)};
    pool_replicates(all);
    for (const Reading& each : all.readings) {
        EXPECT_NEAR(relative_variance(each, 0), 1e-4 + (8e-4 - 1e-4) * one_pair, 1e-12);
        EXPECT_NEAR(relative_variance(each, 1), 1e-4, 1e-12);  // no scatter: nothing added
        EXPECT_FALSE(each.error_assumed);
    }
    ASSERT_EQ(all.notes.size(), 1u);
    EXPECT_THAT(all.notes[0], HasSubstr("one pair only: their standard errors are widened 7.0"));
}

TEST(Replicates, CoverAsOftenAsTheyClaimWhenFew) {
    // 4000 experiments of six pairs and one lone reading of known truth: two of its standard errors
    // must cover it in 95.45 %, to three binomial standard deviations. Unwidened it would be 90.8
    // %.
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    constexpr int experiments = 4000, pairs = 6;
    constexpr double truth = 0.3, scatter = 0.01;
    int covered = 0;
    for (int k = 0; k < experiments; ++k) {
        Measurements all;
        for (int i = 0; i < 2 * pairs; ++i)
            all.readings.push_back(
                reading(1000 * (1 + i / 2), truth * (1 + scatter * normal(random)), 0.6, 1e-6));
        all.readings.push_back(reading(1e5, truth * (1 + scatter * normal(random)), 0.6, 1e-6));
        pool_replicates(all);
        const Reading& lone = all.readings.back();
        covered += std::abs(lone.stress_ratio() - truth) <=
                   2 * std::sqrt(lone.covariance(0, 0)) / lone.condition.normal_stress;
    }
    const double expected = 0.9545, error = std::sqrt(expected * (1 - expected) / experiments);
    EXPECT_NEAR(static_cast<double>(covered) / experiments, expected, 3 * error);
}

TEST(Replicates, DoNotTakeDifferentSetPointsForScatter) {
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0.001), reading(1019, 0.3, 0.6, 0.001)};
    pool_replicates(all);
    EXPECT_NEAR(relative_variance(all.readings[0], 0), 1e-6, 1e-12);
}

TEST(Replicates, RecoverAPlantedScatterAndItsCorrelation) {
    // 200 pairs: 1.5 % between replicates, correlated 0.8 between the observables, 0.5 % within.
    // With 200 degrees of freedom a variance is known to sqrt(2/200) = 10 %: limits of 3 of these.
    std::mt19937_64 random(13);
    std::normal_distribution<double> normal;
    Measurements all;
    for (int i = 0; i < 200; ++i) {
        for (int j = 0; j < 2; ++j) {
            const double a = normal(random), b = 0.8 * a + 0.6 * normal(random);
            all.readings.push_back(reading(1000 * (1 + i),
                                           0.3 * (1 + 0.015 * a + 0.005 * normal(random)),
                                           0.6 * (1 + 0.015 * b + 0.005 * normal(random)), 0.005));
        }
    }
    pool_replicates(all);
    const Reading& first = all.readings.front();
    const double expected = 0.015 * 0.015 + 0.005 * 0.005;
    EXPECT_NEAR(relative_variance(first, 0), expected, 0.3 * expected);
    EXPECT_NEAR(relative_variance(first, 1), expected, 0.3 * expected);
    const double shared = first.covariance(0, 1) / (first.value(0) * first.value(1));
    EXPECT_NEAR(shared, 0.8 * 0.015 * 0.015, 0.3 * 0.8 * 0.015 * 0.015);
}

TEST(Replicates, KnowNoCorrelationFromOnePair) {
    Measurements all;
    all.readings = {reading(1000, 0.29, 0.59, 0.001), reading(1000, 0.31, 0.61, 0.001)};
    pool_replicates(all);
    EXPECT_EQ(all.readings[0].covariance(0, 1), 0);
}

TEST(Replicates, AddNothingASecondTime) {
    Measurements all;
    all.readings = {reading(1000, 0.29, 0.59, 0.01), reading(1000, 0.31, 0.6, 0.01),
                    reading(1000, 0.30, 0.61, 0.01)};
    pool_replicates(all);
    const Eigen::Matrix2d once = all.readings[0].covariance;
    pool_replicates(all);
    for (int i = 0; i < 2; ++i)
        EXPECT_NEAR(all.readings[0].covariance(i, i), once(i, i), 1e-9 * once(i, i));
}

TEST(Replicates, StandInForErrorsThatWereNotGiven) {
    Measurements all;
    all.readings = {reading(1000, 0.29, 0.59, 0), reading(1000, 0.31, 0.61, 0),
                    reading(2000, 0.30, 0.6, 0)};
    pool_replicates(all);
    EXPECT_NEAR(relative_variance(all.readings[2], 0), 2 * std::pow(0.01 / 0.3, 2) * one_pair,
                1e-12);
}

TEST(Replicates, LeaveTwoPercentToBeAssumedWhereNothingIsKnown) {
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0), reading(2000, 0.3, 0.6, 0.01),
                    reading(3000, 0.3, 0.6, 0.01)};
    all.readings[2].covariance(1, 1) = 0;
    pool_replicates(all);
    EXPECT_NEAR(relative_variance(all.readings[0], 0), 4e-4, 1e-12);
    EXPECT_NEAR(relative_variance(all.readings[0], 1), 4e-4, 1e-12);
    EXPECT_TRUE(all.readings[0].error_assumed);
    EXPECT_NEAR(relative_variance(all.readings[1], 0), 1e-4, 1e-12);
    EXPECT_FALSE(all.readings[1].error_assumed);
    EXPECT_NEAR(relative_variance(all.readings[2], 1), 4e-4, 1e-12);
    EXPECT_TRUE(all.readings[2].error_assumed);
    ASSERT_EQ(all.notes.size(), 1u);
    EXPECT_THAT(all.notes[0], AllOf(HasSubstr("2 of 3 readings"), HasSubstr("2 %")));
}

}  // namespace pendular::data_replicates_test
