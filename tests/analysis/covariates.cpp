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

}  // namespace covariates_test
