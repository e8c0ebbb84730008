// Quantities along which residuals are checked for trends.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "analysis/diagnosis/study_evidence.h"

namespace covariates_test {

using namespace pendular;

/// Readings at one condition from files, one each.
std::vector<Reading> from(const std::vector<const char*>& files) {
    std::vector<Reading> readings;
    for (const char* const file : files) {
        readings.emplace_back();
        readings.back().origin = {file, static_cast<int>(readings.size()), 0};
        readings.back().condition.normal_stress = 1000;
    }
    return readings;
}

bool knows_order(const std::vector<Reading>& readings) {
    return std::ranges::any_of(covariates_of(readings, 0),
                               [](const Covariate& each) { return each.name == "run order"; });
}

TEST(RunOrder, IsKnownWithinOneTableOrByTime) {
    EXPECT_TRUE(knows_order(from({"a.csv", "a.csv", "a.csv"})));
    EXPECT_FALSE(knows_order(from({"a.csv", "a.csv", "b.csv"})));
    std::vector<Reading> timed = from({"a.csv", "b.csv", "a.csv"});
    for (std::size_t k = 0; k < 3; ++k)
        timed[k].condition.time = 1000 + 10.0 * static_cast<double>(k);
    EXPECT_TRUE(knows_order(timed));
}

std::vector<std::string> suspects_of(const std::vector<Reading>& readings) {
    std::vector<std::string> names;
    for (const SuspectMeasurement& suspect : evidence_of(readings, {}).suspects) {
        names.push_back(suspect.name);
    }
    return names;
}

TEST(SuspectMeasurements, HoldAllRecordingsSinceAChangeOfTheInstrument) {
    using namespace testing;
    std::vector<Reading> readings =
        from({"dry_1.csv", "dry_2.csv", "wet_1.csv", "wet_2.csv", "wet_1.csv"});
    for (std::size_t k = 0; k < readings.size(); ++k) {
        readings[k].value = {200, 0.6};
        readings[k].covariance = Eigen::Matrix2d::Identity();
        readings[k].condition.liquid_content = k < 2 ? 0 : 0.03;
    }
    EXPECT_THAT(suspects_of(readings), Each(Not(HasSubstr("later")))) << "the order is not known";
    const std::vector<double> times = {0, 100, 200, 400, 300};
    for (std::size_t k = 0; k < readings.size(); ++k) {
        readings[k].condition.time = times[k];
    }
    // Not from wet_1.csv on, since the liquid is added there, nor wet_2.csv alone a second time.
    const std::vector<std::string> names = suspects_of(readings);
    EXPECT_THAT(names, Contains("the readings of dry_2.csv and the 2 later files"));
    EXPECT_THAT(names, Contains(HasSubstr("later")).Times(1));
    readings[0].condition.time = 150;  // dry_1.csv goes on after dry_2.csv has begun
    readings[1].condition.time = 120;
    readings.push_back(readings[0]);
    readings.back().condition.time = 100;
    EXPECT_THAT(suspects_of(readings), Each(Not(HasSubstr("later"))));
}

}  // namespace covariates_test
