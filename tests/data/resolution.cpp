// Digits to which the numbers of a column were rounded.
#include "data/files/resolution.h"

#include <gtest/gtest.h>

namespace data_resolution_test {

using namespace pendular;

double step_of(std::vector<std::string_view> cells, double value) {
    return resolution_of(value, digits_of(cells));
}

TEST(Resolution, IsThatOfTheLongestNumber) {
    EXPECT_DOUBLE_EQ(step_of({"0.58", "1.3"}, 0.58), 0.01);
    EXPECT_DOUBLE_EQ(step_of({"301", "300"}, 300), 1);
}

TEST(Resolution, CountsTrailingZeros) {
    EXPECT_DOUBLE_EQ(step_of({"300.0", "600.0"}, 300), 0.1);
    EXPECT_DOUBLE_EQ(step_of({"0.600", "0.600"}, 0.6), 0.001);
    EXPECT_DOUBLE_EQ(step_of({"300", "600"}, 300), 1);
    EXPECT_DOUBLE_EQ(step_of({"3.00e2", "6.00e2"}, 300), 1);
    EXPECT_DOUBLE_EQ(step_of({"0.0", "0.0"}, 0), 0) << "a zero has no step";
}

TEST(Resolution, KnowsExponents) {
    EXPECT_DOUBLE_EQ(step_of({"5.8e-1", "6.1E-01"}, 0.58), 0.01);
    EXPECT_DOUBLE_EQ(step_of({"1.25e+3", "1.3e3"}, 1250), 10);
}

}  // namespace data_resolution_test
