#include "data/recordings/reading_groups.h"

#include <cmath>
#include <random>

#include "tests/support/data_support.h"

namespace pendular::data_binned_readings_test {

/// Stress ratio [1] that is linear in 1/(normal stress) and in sqrt(I), as readings are averaged.
double line(const Condition& c) {
    return 0.25 + 0.4 * std::sqrt(c.inertial_number) + 30 / c.normal_stress;
}

/// Readings at random conditions, with relative errors of 2 % and 0.5 %.
std::vector<Reading> readings_at_random(std::size_t count, double scatter) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> even(0, 1);
    std::normal_distribution<double> normal;
    std::vector<Reading> readings(count);
    for (std::size_t k = 0; k < count; ++k) {
        Reading& r = readings[k];
        r.origin = {"points.csv", static_cast<int>(k) + 2};
        r.condition = {.normal_stress = 300 * std::pow(10, even(random)),
                       .inertial_number = 0.003 * std::pow(30, even(random)),
                       .liquid_content = k % 4 == 0 ? 0.03 : 0};
        const Eigen::Vector2d exact(line(r.condition) * r.condition.normal_stress, 0.6);
        const Eigen::Vector2d errors = exact.cwiseProduct(Eigen::Vector2d(0.02, 0.005));
        r.value =
            exact + scatter * errors.cwiseProduct(Eigen::Vector2d(normal(random), normal(random)));
        r.covariance = errors.cwiseAbs2().asDiagonal();
    }
    return readings;
}

TEST(BinnedReadings, AreTheReadingsWhereThereAreFew) {
    const auto readings = readings_at_random(50, 1);
    const auto same = binned_readings(readings, 50);
    ASSERT_EQ(same.size(), 50);
    EXPECT_EQ(same[7].value, readings[7].value);
    EXPECT_EQ(same[7].condition, readings[7].condition);
}

TEST(BinnedReadings, LieOnALawThatTheReadingsFollow) {
    const auto bins = binned_readings(readings_at_random(2000, 0), 100);
    ASSERT_EQ(bins.size(), 100);
    for (const Reading& bin : bins) {
        EXPECT_NEAR(bin.stress_ratio(), line(bin.condition), 1e-12);
        EXPECT_NEAR(bin.value(1), 0.6, 1e-12);
    }
}

TEST(BinnedReadings, DeviateByTheErrorsThatTheyState) {
    const auto bins = binned_readings(readings_at_random(2000, 1), 100);
    double chi2 = 0, information = 0;
    for (const Reading& bin : bins) {
        const Eigen::Vector2d exact(line(bin.condition) * bin.condition.normal_stress, 0.6);
        const Eigen::Vector2d error = bin.covariance.diagonal().cwiseSqrt();
        chi2 += (bin.value - exact).cwiseQuotient(error).squaredNorm();
        information += std::pow(0.005 * 0.6 / error(1), 2);
    }
    EXPECT_NEAR(chi2, 200, 4 * std::sqrt(2 * 200));
    EXPECT_NEAR(information, 2000, 1);  // as many as the readings have together
}

TEST(BinnedReadings, KeepApartWhatIsOfAnotherKind) {
    auto readings = readings_at_random(400, 0);
    for (std::size_t k = 0; k < readings.size(); ++k) {
        if (k % 2 == 0) readings[k].origin.file = "others.csv";
        readings[k].condition.at_failure = k % 5 == 0;
    }
    for (const Reading& bin : binned_readings(readings, 40)) {
        const auto k = static_cast<std::size_t>(bin.origin.line - 2);
        EXPECT_EQ(bin.condition.liquid_content, readings[k].condition.liquid_content);
        EXPECT_EQ(bin.condition.at_failure, readings[k].condition.at_failure);
        EXPECT_EQ(bin.origin.file, readings[k].origin.file);
    }
}

TEST(BinnedReadings, AverageNoErrorThatTheyShare) {
    const Reading one = readings_at_random(2, 0)[1];
    std::vector<Reading> readings(100, one);
    for (Reading& r : readings) {
        r.condition.time = static_cast<double>(&r - readings.data());
        r.shared = {{.source = 7, .size = 0.01 * r.value}};
        r.covariance += r.shared[0].size * r.shared[0].size.transpose();
    }
    for (const Reading& bin : binned_readings(readings, 2)) {
        ASSERT_EQ(bin.shared.size(), 1);
        EXPECT_NEAR(bin.shared[0].size(0), 0.01 * bin.value(0), 1e-9);
        EXPECT_NEAR(bin.covariance(0, 0),
                    std::pow(bin.value(0), 2) * (std::pow(0.02, 2) / 50 + std::pow(0.01, 2)),
                    1e-9 * std::pow(bin.value(0), 2));
    }
}

TEST(BinnedReadings, KeepTimesApartAtOneCondition) {
    auto readings = readings_at_random(300, 0);
    for (Reading& r : readings) {
        r.condition = readings[1].condition;
        r.condition.time = static_cast<double>(&r - readings.data());
    }
    const auto bins = binned_readings(readings, 10);
    ASSERT_EQ(bins.size(), 10);
    EXPECT_GT(bins.back().condition.time - bins.front().condition.time, 200);
}

}  // namespace pendular::data_binned_readings_test
