// Factors in units: "10³ Pa" is how ISO 80000 heads a column in kilopascals. UDUNITS reads ".10" as
// a decimal and would take digits that are raised no longer, "103", for the factor itself.
#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "data/quantities/units.h"
#include "data/recordings/file_view.h"
#include "tests/support/golden.h"

namespace pendular::data_powers_of_ten_test {

using testing::DoubleEq;
using testing::DoubleNear;
using testing::ElementsAre;

struct Factor {
    const char* unit;
    const char* si;
    double factor;
};

TEST(PowerOfTen, IsAFactorOfAUnitInAnyWriting) {
    for (const Factor& each :
         std::vector<Factor>{{"10³ Pa", "Pa", 1e3},         {"10² Pa", "Pa", 1e2},
                             {"10¹ Pa", "Pa", 10},          {"10⁶ Pa", "Pa", 1e6},
                             {"10¹² Pa", "Pa", 1e12},       {"10⁻³ N·m", "N m", 1e-3},
                             {"10⁻¹² N·m", "N m", 1e-12},   {"10^3 Pa", "Pa", 1e3},
                             {"10^-3 N m", "N m", 1e-3},    {"10−3 N m", "N m", 1e-3},
                             {"10**3 Pa", "Pa", 1e3},       {"10**-3 N*m", "N m", 1e-3},
                             {"10³Pa", "Pa", 1e3},          {"10³ kg/m³", "kg/m^3", 1e3},
                             {"10³·kg·m⁻³", "kg/m^3", 1e3}, {"Pa·10³", "Pa", 1e3},
                             {"N·m·10⁻³", "N m", 1e-3},     {"1000 Pa", "Pa", 1e3},
                             {"1e3 Pa", "Pa", 1e3},         {"1E-3 N m", "N m", 1e-3},
                             {"0.001 N m", "N m", 1e-3},    {"N · m", "N m", 1},
                             {"m²·s⁻²", "m^2/s^2", 1},      {"10⁻³", "1", 1e-3},
                             {"10³ 1/s", "1/s", 1e3},       {"s-¹", "1/s", 1},
                             {"10-³ Pa", "Pa", 1e-3}}) {
        SCOPED_TRACE(each.unit);
        const Unit unit(each.unit);
        EXPECT_TRUE(unit.same_dimension(Unit(each.si)));
        EXPECT_NEAR(unit.to_si(1), each.factor, 1e-12 * each.factor);
    }
}

/// A factor that may be another is refused: of "10³" a program may leave "103" or "10 3", and
/// "×1000 Pa" may head numbers that were multiplied by it.
TEST(PowerOfTen, IsRefusedWhereItMayBeAnother) {
    std::vector<std::string> told;
    for (const char* const unit :
         {"103 Pa",   "106 Pa",     "1012 Pa",   "10 3 Pa",   "10 -3 N m", "10e3 Pa",  "10E-3 N m",
          "10 ³ Pa",  "10 000 Pa",  "Pa·103",    "×10⁻³ N·m", "×1000 Pa",  "· 10³ Pa", "x1000 N m",
          "*10^3 Pa", "N m × 1000", "Pa x 10^3", "Pa*1000",   "Pa (×10³)", "*",        "×"}) {
        try {
            const Unit taken(unit);
            ADD_FAILURE() << unit << " is taken for " << taken.to_si(1);
        } catch (const std::invalid_argument& error) {
            told.emplace_back(error.what());
        }
    }
    expect_told(told);
}

TEST(PowerOfTen, BelongsToTheNumberOfAQuantity) {
    const auto density = [](const char* text) { return quantity_in_si(text, Unit("kg/m^3")); };
    for (const char* const text :
         {"2.5·10^3 kg/m³", "2.5*10^3 kg/m³", "2.5 * 10^3 kg/m^3", "2.5×10³ kg/m³",
          "2.5 x 10^3 kg/m^3", "2.5x10³ kg/m³", "2.5e3 kg/m^3", "2.5 10^3 kg/m³"})
        EXPECT_THAT(density(text), DoubleNear(2500, 1e-9)) << text;
    EXPECT_THAT(density("10³ kg/m³"), DoubleEq(1000));
    EXPECT_THAT(density("103 kg/m³"), DoubleEq(103));
    EXPECT_THAT(quantity_in_si("5·10⁻⁴ m", Unit("m")), DoubleNear(5e-4, 1e-18));
    EXPECT_THAT(quantity_in_si("10^-3 m", Unit("m")), DoubleNear(1e-3, 1e-18));
}

/// A table with 1, 2 and 3 in a column of normal stresses.
std::string table(const std::string& names) {
    return names + "\n1;0.71\n2;1.22\n3;1.73\n";
}

TEST(PowerOfTen, StandsInTheHeaderOfAColumn) {
    const TemporaryFolder folder;
    for (const char* const names : {"Normal stress / 10³ Pa;Shear stress / 10³ Pa",
                                    "Normal stress [10³ Pa];Shear stress [10³ Pa]",
                                    "Normal stress/(10³ Pa);Shear stress/(10³ Pa)",
                                    "Normal stress in 10^3 Pa;Shear stress in 10^3 Pa",
                                    "Normal stress [Pa·10³];Shear stress [10³ × Pa]",
                                    "Normal stress;Shear stress\n[10³ Pa];[10³ Pa]",
                                    "Normal stress;Shear stress\n10³ Pa;10³ Pa"}) {
        const FileView view = view_of_file(folder.write("t.csv", table(names)));
        ASSERT_EQ(view.loci.size(), 1u) << names;
        EXPECT_NEAR(view.loci[0].line->cohesion, 200, 1e-9) << names;
    }
}

/// Behind a name, a factor may be one of the quantity or of its numbers.
TEST(PowerOfTen, BehindANameIsNotGuessed) {
    const TemporaryFolder folder;
    for (const char* const torque :
         {"Torque × 10³ [N m]", "Torque x1000 [N m]", "Torque·10³ [N m]", "10³ Torque [N m]",
          "Torque*10^3 / N m", "1000 × Couple [N·m]", "1000 x Torque [N m]", "10 × Couple [mN·m]",
          "1000·Couple [N·m]", "Couple/10 [mN·m]", "Couple ÷ 10 [mN·m]"}) {
        const FileView view = view_of_file(
            folder.write("t.csv", "Time [s]," + std::string(torque) +
                                      ",Normal force [N],Gap [mm],Speed [rpm]\n0,15,12,6.2,2\n"
                                      "1,15,12,6.2,2\n"));
        EXPECT_TRUE(view.by_unit.empty()) << torque;
        EXPECT_THAT(view.missing, ElementsAre("torque or shear stress")) << torque;
    }
}

/// Nobody shears beads by a meganewton: capital letters for small ones.
TEST(Units, RefuseMegaForMilliInForces) {
    for (const char* const unit : {"MN m", "MN·m", "MN.m", "MN", "MNm", "MNmm", "MN/m", "Ms"})
        EXPECT_THROW(Unit{unit}, std::invalid_argument) << unit;
    EXPECT_EQ(Unit("MPa").to_si(1), 1e6);
}

TEST(Units, KnowGermanHours) {
    for (const char* const hours : {"Std", "Std.", "Stunden"})
        EXPECT_EQ(Unit(hours).to_si(1), 3600) << hours;
    EXPECT_EQ(parse_header_cell("Zeit Std").unit, "Std");
    EXPECT_EQ(parse_header_cell("Drehmoment Std").mark, ErrorMark::standard_deviation);
}

TEST(Units, KnowStressesAsEngineersWriteThem) {
    EXPECT_DOUBLE_EQ(Unit("0,1 MPa").to_si(1), 1e5);
    EXPECT_DOUBLE_EQ(Unit("10 ^ 3 Pa").to_si(1), 1e3);
    EXPECT_DOUBLE_EQ(Unit("tf/m²").to_si(1), 9806.65);
    EXPECT_NEAR(Unit("mm WS").to_si(1), 9.80665, 1e-4);
    EXPECT_THROW(Unit("tonf/m2"), std::invalid_argument) << "of 1000 kg, or of 2000 lb";
}

}  // namespace pendular::data_powers_of_ten_test
