// Units in which values of effects' parameters are printed.
#include "data/effect_parameter.h"

#include <gtest/gtest.h>

namespace printed_unit_test {

using pendular::EffectParameter;
using pendular::printed_bounds;
using pendular::printed_unit;
using pendular::printed_value;

EffectParameter parameter(const std::string& unit, double largest) {
    return {.name = "size", .unit = unit, .lower = -largest, .upper = largest};
}

TEST(PrintedUnit, IsTheOneOfTheBounds) {
    EXPECT_EQ(printed_unit(parameter("N m", 0.1)).name, "mN m");
    EXPECT_EQ(printed_unit(parameter("N", 10)).name, "N");
    EXPECT_EQ(printed_unit(parameter("N", 1e-4)).name, "uN");
    EXPECT_EQ(printed_unit(parameter("m", 2e-3)).name, "mm");
    EXPECT_EQ(printed_unit(parameter("Pa s", 0.5)).name, "mPa s");
    EXPECT_EQ(printed_unit(parameter("1", 0.1)).name, "1");
    EXPECT_EQ(printed_unit(parameter("rad", 1.5)).name, "deg");
}

// "mm^2" is (1e-3 m)^2, and "m1/s" is no unit.
TEST(PrintedUnit, HasNoPrefixWhereAPrefixWouldMeanSomethingElse) {
    for (const char* unit : {"m^2", "1/s", "kg/m^3"}) {
        EXPECT_EQ(printed_unit(parameter(unit, 1e-2)).name, unit);
    }
}

TEST(PrintedUnit, IsTheSameForAllValuesOfAParameter) {
    const EffectParameter torque = parameter("N m", 0.1);
    EXPECT_EQ(printed_value(-8.5e-5, torque), "-0.085 mN m");
    EXPECT_EQ(printed_value(0.02, torque), "20 mN m");
    EXPECT_EQ(printed_bounds(torque), "-100 to 100 mN m");
    EXPECT_EQ(printed_value(0.17453292519943295, parameter("rad", 1.5)), "10 deg");
    EXPECT_EQ(printed_value(1.02, parameter("1", 2)), "1.02");
}

}  // namespace printed_unit_test
