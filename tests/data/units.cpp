#include "data/quantities/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "data/quantities/number.h"
#include "tests/support/golden.h"

namespace pendular::data_units_test {

std::string refusal(const std::string& text, const std::string& expected) {
    try {
        quantity_in_si(text, Unit(expected));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    ADD_FAILURE() << text << " was taken for a quantity in " << expected;
    return "";
}

struct Spelling {
    const char* unit;
    const char* si;
    double factor;
};

// The factors follow from the definitions: kgf = 9.80665 N, turn = 2 pi rad, P = 0.1 Pa s.
const Spelling spellings[] = {
    {"Nm", "N m", 1},
    {"N·m", "N m", 1},
    {"N*m", "N m", 1},
    {"N-m", "N m", 1},
    {"mNm", "N m", 1e-3},
    {"mN m", "N m", 1e-3},
    {"mN.m", "N m", 1e-3},
    {"µNm", "N m", 1e-6},
    {"uNm", "N m", 1e-6},
    {"kNm", "N m", 1e3},
    {"Ncm", "N m", 1e-2},
    {"N.mm", "N m", 1e-3},
    {"kgf cm", "N m", 0.0980665},
    {"gf cm", "N m", 9.80665e-5},
    {"gf", "N", 9.80665e-3},
    {"kgf", "N", 9.80665},
    {"dyn cm", "N m", 1e-7},
    {"µm", "m", 1e-6},  // micro sign
    {"μm", "m", 1e-6},  // Greek mu
    {"um", "m", 1e-6},
    {"micron", "m", 1e-6},
    {"kPa", "Pa", 1e3},
    {"N/m²", "Pa", 1},
    {"N/m^2", "Pa", 1},
    {"mPa.s", "Pa s", 1e-3},
    {"mPa·s", "Pa s", 1e-3},
    {"mPas", "Pa s", 1e-3},
    {"cP", "Pa s", 1e-3},
    {"mN/m", "N/m", 1e-3},
    {"g/cm^3", "kg/m^3", 1e3},
    {"g/cm3", "kg/m^3", 1e3},
    {"kg/m³", "kg/m^3", 1},
    {"kg m-3", "kg/m^3", 1},
    {"1/s", "s^-1", 1},
    {"s⁻¹", "s^-1", 1},
    {"1/min", "s^-1", 1.0 / 60},
    {"rad/min", "rad/s", 1.0 / 60},
    {"deg", "rad", std::numbers::pi / 180},
    {"°", "rad", std::numbers::pi / 180},
    {"deg/s", "rad/s", std::numbers::pi / 180},
    {"rpm", "rad/s", std::numbers::pi / 30},
    {"RPM", "rad/s", std::numbers::pi / 30},
    {"rev/min", "rad/s", std::numbers::pi / 30},
    {"tr/min", "rad/s", std::numbers::pi / 30},
    {"%", "1", 0.01},
    {"-", "1", 1},
    {"", "1", 1},
};

TEST(Units, ReadCommonSpellings) {
    for (const Spelling& each : spellings) {
        SCOPED_TRACE(each.unit);
        const Unit unit(each.unit);
        EXPECT_TRUE(unit.same_dimension(Unit(each.si)));
        EXPECT_NEAR(unit.to_si(1), each.factor, 1e-12 * each.factor);
    }
}

/// Turns and degrees as they are written in French, Italian and Spanish.
TEST(Units, ReadSpeedsInWords) {
    for (const char* const turns : {"r.p.m", "vueltas/minuto", "giri al minuto", "giri/1'",
                                    "vueltas por minuto", "tours par minute"})
        EXPECT_TRUE(Unit(turns).same_dimension(Unit("rpm")) &&
                    std::abs(Unit(turns).to_si(60) / Unit("turn/s").to_si(1) - 1) < 1e-9)
            << turns;
    for (const char* const degrees : {"degrés/s", "gradi/s", "grados/s"})
        EXPECT_NEAR(Unit(degrees).to_si(180), M_PI, 1e-9) << degrees;
}

TEST(Units, SuggestTheForceForATonne) {
    EXPECT_EQ(weight_meant("t/m²"), "tf/m²");
    EXPECT_EQ(weight_meant("t"), "");  // a time
    EXPECT_THROW(Unit("Kpa"), std::invalid_argument);
}

TEST(Units, KeepOffsets) {
    EXPECT_NEAR(Unit("degC").to_si(20), 293.15, 1e-9);
}

TEST(Units, TellApartWhatMeasuresDifferentThings) {
    EXPECT_FALSE(Unit("mN m").same_dimension(Unit("mN/m")));
    EXPECT_FALSE(Unit("rad").same_dimension(Unit("1")));
    EXPECT_FALSE(Unit("Pa").same_dimension(Unit("Pa s")));
}

TEST(Units, RefuseWordsThatAreNone) {
    for (const char* word : {"bananas", "N m;", "2", "10", "lg(re 1 W)", "/s"})
        EXPECT_THROW(Unit{word}, std::invalid_argument) << word;
}

TEST(Units, RefuseWrongCaseWithTheRightOne) {
    // UDUNITS reads "pa" as a pico-are, 1e-10 m^2.
    expect_told({refusal("3 pa", "Pa"), refusal("3 kpa", "Pa"), refusal("3 KPa", "Pa")});
}

TEST(Quantities, AreReadWithTheirUnit) {
    EXPECT_DOUBLE_EQ(quantity_in_si("500 um", Unit("m")), 500e-6);
    EXPECT_DOUBLE_EQ(quantity_in_si("  20.6mN/m ", Unit("N/m")), 20.6e-3);
    EXPECT_DOUBLE_EQ(quantity_in_si("3.3e9 Pa", Unit("Pa")), 3.3e9);
    EXPECT_DOUBLE_EQ(quantity_in_si("3 %", Unit("1")), 0.03);
    EXPECT_DOUBLE_EQ(quantity_in_si("0.3", Unit("1")), 0.3);
}

TEST(Quantities, RefuseAMassTimesALengthAsTorqueAndSuggestTheWeight) {
    expect_told({refusal("5 g.cm", "N m"), refusal("5 kg cm", "N m")});
}

TEST(Quantities, RefuseAnotherDimension) {
    expect_told({refusal("21 kg", "m"), refusal("10 deg", "1")});
}

TEST(Quantities, RefuseANumberWithoutUnit) {
    expect_told({refusal("21", "m")});
}

TEST(Quantities, RefuseWhatIsNoNumber) {
    expect_told(
        {refusal("large", "m"), refusal("1,25 m", "m"), refusal("nan m", "m"), refusal("", "m")});
}

TEST(Quantities, AreNoProductOfTwoNumbers) {
    for (const char* const text : {"2 650 kg/m^3", "2 100 kg/m^3", "2 10 kg/m^3", "2 10kg/m^3"})
        EXPECT_THROW(quantity_in_si(text, Unit("kg/m^3")), std::invalid_argument) << text;
    EXPECT_DOUBLE_EQ(quantity_in_si("2.65 10^3 kg/m^3", Unit("kg/m^3")), 2650);
    EXPECT_DOUBLE_EQ(quantity_in_si("2 1/s", Unit("1/s")), 2);
}

TEST(Quantities, ComeInListsThatShareAUnit) {
    using testing::ElementsAre;
    EXPECT_THAT(quantities_in_si("0.3, 1, 3 kPa", Unit("Pa")), ElementsAre(300, 1000, 3000));
    EXPECT_THAT(quantities_in_si("500 Pa,2,3 kPa", Unit("Pa")), ElementsAre(500, 2000, 3000));
    EXPECT_THAT(quantities_in_si("0.007, 3 %", Unit("1")),
                ElementsAre(testing::DoubleEq(7e-5), 0.03));
    EXPECT_THAT(quantities_in_si(" 0.1", Unit("1")), ElementsAre(0.1));
    const auto refused = [](const std::string& list) -> std::string {
        try {
            quantities_in_si(list, Unit("Pa"));
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    expect_told({refused("1 kPa, 2"), refused("1, , 2 kPa"), refused("1, 2 mm"), refused("")});
}

TEST(Units, HaveAnSiUnitInTheirOwnSpelling) {
    EXPECT_EQ(si_spelling(Unit("mN m s/rad")), "N m s/rad");
    EXPECT_EQ(si_spelling(Unit("kPa s^2")), "Pa s^2");
    EXPECT_EQ(si_spelling(Unit("uN/K")), "N/K");
    EXPECT_EQ(si_spelling(Unit("kPa")), "Pa");
    EXPECT_EQ(si_spelling(Unit("kg m^2")), "kg m^2");
    EXPECT_EQ(Unit(si_spelling(Unit("N m/min"))).to_si(1), 1);
}

TEST(Units, CanBeReadFromSeveralThreads) {
    std::vector<std::thread> threads;
    std::vector<double> sums(4, 0);
    for (double& sum : sums)
        threads.emplace_back([&sum] {
            for (int i = 0; i < 200; ++i)
                sum += Unit(i % 2 ? "kPa" : "mNm").to_si(1);
        });
    for (std::thread& thread : threads)
        thread.join();
    for (const double sum : sums)
        EXPECT_NEAR(sum, 100 * (1e3 + 1e-3), 1e-6);
}

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

}  // namespace pendular::data_units_test
