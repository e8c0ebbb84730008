// The expected error of a model, as an error that readings share.
#include "calib/fit/discrepancy.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "calib/fit/fit.h"

namespace calib_discrepancy_test {

using namespace pendular;

std::vector<Reading> some_readings() {
    std::vector<Reading> readings;
    for (const double stress : {300.0, 1000.0, 3000.0}) {
        for (const double content : {0.0, 0.03}) {
            Reading reading;
            reading.condition = {
                .normal_stress = stress, .inertial_number = 0.01, .liquid_content = content};
            reading.value = {0.3 * stress, 0.61};
            reading.covariance = Eigen::Vector2d(stress * 1e-3, 1e-3).cwiseAbs2().asDiagonal();
            readings.push_back(reading);
        }
    }
    return readings;
}

TEST(Discrepancy, AddsASmoothErrorToTheCovarianceOfReadings) {
    const std::vector<Reading> exact = some_readings();
    std::vector<Reading> readings = exact;
    add_discrepancy(readings, {0.005, 0.001});
    const Eigen::MatrixXd added = stack(readings).covariance - stack(exact).covariance;
    for (std::size_t i = 0; i < readings.size(); ++i) {
        for (std::size_t k = 0; k < readings.size(); ++k) {
            const double correlation =
                discrepancy_correlation(exact[i].condition, exact[k].condition);
            const auto at = [](std::size_t reading) {
                return 2 * static_cast<Eigen::Index>(reading);
            };
            EXPECT_NEAR(added(at(i), at(k)),
                        0.005 * 0.005 * correlation * exact[i].value(0) * exact[k].value(0),
                        1e-4 * added(at(i), at(i)));
            EXPECT_NEAR(added(at(i) + 1, at(k) + 1), 0.001 * 0.001 * correlation * 0.61 * 0.61,
                        1e-4 * added(at(i) + 1, at(i) + 1));
            EXPECT_EQ(added(at(i), at(k) + 1), 0);
        }
    }
}

TEST(Discrepancy, IsSmoothOverADecadeOfStress) {
    const std::vector<Reading> readings = some_readings();
    EXPECT_EQ(discrepancy_correlation(readings[0].condition, readings[0].condition), 1);
    EXPECT_NEAR(discrepancy_correlation(readings[0].condition, readings[4].condition),
                std::exp(-0.5), 1e-12);
    EXPECT_LT(discrepancy_correlation(readings[0].condition, readings[1].condition), 0.5);
}

TEST(Discrepancy, LeavesReadingsOfAnExactModelAlone) {
    std::vector<Reading> readings = some_readings();
    add_discrepancy(readings, {0, 0});
    EXPECT_TRUE(readings[0].shared.empty());
    EXPECT_EQ(readings[0].covariance, some_readings()[0].covariance);
}

TEST(Discrepancy, LeavesOtherSharedErrorsApart) {
    std::vector<Reading> readings = some_readings();
    readings[2].shared.push_back({.source = 7});
    add_discrepancy(readings, {0.01, 0});
    for (const SharedError& error : readings[0].shared) {
        EXPECT_GT(error.source, 7u);
        EXPECT_TRUE(error.known);
    }
}

}  // namespace calib_discrepancy_test
