// Errors that a table of readings states, against the scatter of its replicates.
#include <cmath>
#include <numbers>
#include <random>

#include "data/recordings/measurements.h"
#include "tests/support/golden.h"
#include "tests/support/replicated_readings.h"

namespace pendular::data_stated_errors_test {

using namespace replicated;
using testing::Contains;
using testing::IsEmpty;
using testing::Not;

TEST(StatedErrors, BelowTheirRoundingAreNamed) {
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0.001), reading(2000, 0.3, 0.6, 0.001)};
    all.readings[0].resolution = {0, 0.01};  // rounding makes errors of 0.0029
    Measurements fine = all;
    pool_replicates(all);
    expect_told(texts(all.notes()));
    EXPECT_GE(all.readings[0].covariance(1, 1), 1e-4 / 12);
    fine.readings[0].resolution = {0, 0.001};
    pool_replicates(fine);
    const auto count = [](const Measurements& measured) {
        return std::ranges::count(measured.notes(), Remark::Kind::errors_below_rounding,
                                  &Remark::kind);
    };
    EXPECT_EQ(count(all), 1);
    EXPECT_EQ(count(fine), 0);
}

TEST(StatedErrors, AreRefutedOnlyWhereReplicatesScatterSignificantlyMore) {
    // One pair among 20 readings with stated errors of 1 %: a mean square of q (1 %)^2 has the chi2
    // value q with one degree of freedom, whose 2.5 % quantile is 5.02 (two observables are
    // tested).
    const auto freedom_at = [](double chi2) {
        Measurements all;
        for (int i = 0; i < 20; ++i)
            all.readings.push_back(reading(1000 * (1 + i), 0.3, 0.6, 0.01));
        all.readings.push_back(
            reading(1000, 0.3 * std::exp(0.01 * std::sqrt(2 * chi2)), 0.6, 0.01));
        pool_replicates(all);
        return all.readings[5].scatter_freedom(0);
    };
    EXPECT_TRUE(std::isinf(freedom_at(5.0)));
    EXPECT_EQ(freedom_at(5.1), 1);
}

/// Notes on stated errors of 1 % where ten pairs scatter by a share of them.
std::vector<Remark> notes_on_pairs(double share, double resolution = 0) {
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    Measurements all;
    for (int i = 0; i < 20; ++i) {
        const double z = share * 0.01 * normal(random), y = 0.01 * normal(random);
        all.readings.push_back(
            reading(100 * std::pow(1.2, i / 2), 0.3 * std::exp(z), 0.6 * std::exp(y), 0.01));
        all.readings.back().resolution(0) = resolution * all.readings.back().value(0);
    }
    pool_replicates(all);
    return all.notes();
}

TEST(StatedErrors, AreTestedFromBothSides) {
    // Chi2 with ten degrees of freedom is below 2.16 or above 20.5 by chance with 0.5 and 2.5 %:
    // a share of 1/3 or 3 makes about 1.1 or 90.
    using Kind = Remark::Kind;
    EXPECT_THAT(notes_on_pairs(1), IsEmpty());
    const std::vector<Remark> large = notes_on_pairs(1.0 / 3), small = notes_on_pairs(3);
    ASSERT_EQ(large.size(), 1u);
    EXPECT_EQ(large[0].kind, Kind::errors_above_scatter);
    EXPECT_EQ(large[0].quantity, "shear_stress");
    EXPECT_LT(large[0].p, 0.005);
    EXPECT_NEAR(large[0].relative, 1.0 / 3, 0.15);  // ten differences: to a quarter
    ASSERT_GE(small.size(), 1u);
    EXPECT_EQ(small[0].kind, Kind::errors_below_scatter);
    EXPECT_NEAR(small[0].relative, 3, 1.5);
    expect_told({text_of(large[0]), text_of(small[0])});
    // Replicates that agree because they are rounded say nothing: a step of 3 %.
    EXPECT_THAT(notes_on_pairs(1.0 / 3, 0.03),
                Not(Contains(testing::Field(&Remark::kind, Kind::errors_above_scatter))));
}

TEST(StatedErrors, AreSeldomRefutedWhereHonest) {
    // 400 tables of six pairs whose errors are right: too large for at most 1 % (both quantities
    // together), too small for 5 %, each with three standard deviations of the count.
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    int large = 0, small = 0;
    constexpr int tables = 400;
    for (int table = 0; table < tables; ++table) {
        Measurements all;
        for (int i = 0; i < 12; ++i)
            all.readings.push_back(reading(100 * std::pow(1.2, i / 2),
                                           0.3 * std::exp(0.01 * normal(random)),
                                           0.6 * std::exp(0.01 * normal(random)), 0.01));
        pool_replicates(all);
        const auto has = [&](Remark::Kind kind) {
            return std::ranges::count(all.remarks, kind, &Remark::kind) > 0;
        };
        large += has(Remark::Kind::errors_above_scatter);
        small += has(Remark::Kind::errors_below_scatter);
    }
    EXPECT_LE(large, 0.01 * tables + 3 * std::sqrt(0.01 * tables));
    EXPECT_LE(small, 0.05 * tables + 3 * std::sqrt(0.05 * tables));
}

TEST(StatedErrors, OfSomeReadingsAreNotThoseOfOthers) {
    // The second reading of a pair states no error: that of the first is not its own.
    Measurements all;
    all.readings = {reading(1000, 0.3, 0.6, 0.01), reading(1000, 0.3 * 1.02, 0.6 * 1.02, 0),
                    reading(3000, 0.3, 0.6, 0.01)};
    all.readings[2].origin.file = "other.csv";
    pool_replicates(all);
    EXPECT_EQ(all.readings[1].scatter_freedom(0), 1);
    EXPECT_GT(relative_variance(all.readings[1], 0), 1e-5);
    EXPECT_TRUE(std::isinf(all.readings[2].scatter_freedom(0))) << "stated, and not refuted";
}

TEST(StatedErrors, AreNotRefutedByReplicatesOfAnotherCluster) {
    // Ten pairs state 1 % and scatter so, five state 0.5 % and scatter so: both agree.
    Measurements all;
    const auto add_pairs = [&](int count, double error, double least, const std::string& file) {
        for (int i = 0; i < 2 * count; ++i) {
            const double sign = i % 2 == 0 ? 1 : -1;
            const double ratio = 0.3 * std::exp(sign * error / std::numbers::sqrt2);
            all.readings.push_back(
                reading(least * std::pow(1.2, i / 2), ratio, 0.6 * ratio / 0.3, error));
            all.readings.back().origin.file = file;
        }
    };
    add_pairs(10, 0.01, 100, "a.csv");
    add_pairs(5, 0.005, 1e4, "b.csv");
    pool_replicates(all);
    ASSERT_EQ(all.scatter.groups.size(), 2u);
    for (const Reading& each : all.readings) {
        EXPECT_TRUE(std::isinf(each.scatter_freedom(0)));
    }
    EXPECT_TRUE(std::isinf(all.scatter.correlation_freedom));
}

}  // namespace pendular::data_stated_errors_test
