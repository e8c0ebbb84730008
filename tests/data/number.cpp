#include "data/quantities/number.h"

#include <gtest/gtest.h>

namespace pendular::data_number_test {

TEST(ShortText, HasThreeDigitsAndNoExponentForUsualNumbers) {
    EXPECT_EQ(short_text(1000), "1000");
    EXPECT_EQ(short_text(999.93), "1000");
    EXPECT_EQ(short_text(-12345), "-12300");
    EXPECT_EQ(short_text(299.94), "300");
    EXPECT_EQ(short_text(0.01234), "0.0123");
    EXPECT_EQ(short_text(2e7), "2e+07");
    EXPECT_EQ(short_text(0), "0");
    EXPECT_EQ(nominal_text(199.9), "200");
    EXPECT_EQ(nominal_text(4997), "5000");
    EXPECT_EQ(nominal_text(0.00999), "0.01");
    EXPECT_EQ(nominal_text(312), "312");
    EXPECT_EQ(nominal_text(203), "203");
    EXPECT_EQ(nominal_text(0), "0");
}

}  // namespace pendular::data_number_test
