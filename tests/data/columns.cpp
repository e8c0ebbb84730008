#include "data/files/columns.h"
#include "data/files/header_names.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "data/files/header_cell.h"
#include "data/quantities/units.h"
#include "tests/support/golden.h"

namespace pendular::data_columns_test {

using testing::ElementsAre;

TEST(Quantities, HaveOneNameAndOneMeaningPerSpelling) {
    std::set<std::string_view> names;
    for (const Quantity& each : quantities()) {
        EXPECT_TRUE(names.insert(each.name).second) << each.name;
        EXPECT_FALSE(each.meaning.empty()) << each.name;
        EXPECT_NO_THROW(Unit{each.unit}) << each.name;
        EXPECT_EQ(find_quantity(each.name), &each) << each.name;
        for (const std::string_view other : each.also)
            EXPECT_EQ(find_quantity(other), &each) << other;
    }
}

TEST(Quantities, AreFoundInAnyCaseAndSeparator) {
    for (const char* spelling : {"normal_force", "Normal force", "NormalForce", "NORMAL-FORCE",
                                 "F_N", "Fn", "Axial Force"})
        EXPECT_EQ(find_quantity(spelling), &quantity("normal_force")) << spelling;
    EXPECT_EQ(find_quantity("T"), &quantity("torque"));
    EXPECT_EQ(find_quantity("t"), &quantity("time"));
    EXPECT_EQ(find_quantity("Gap"), &quantity("height"));
    EXPECT_EQ(find_quantity("colour"), nullptr);
}

TEST(HeaderCell, IsTakenApart) {
    const auto parts = [](const char* text) {
        const HeaderCell cell = parse_header_cell(text);
        const std::string marks[] = {"", "se", "sd", "u95"};
        return cell.name + "|" + cell.unit + "|" + marks[static_cast<int>(cell.mark)];
    };
    EXPECT_EQ(parts("Torque [mN m]"), "Torque|mN m|");
    EXPECT_EQ(parts(" Torque[mN m] "), "Torque|mN m|");
    EXPECT_EQ(parts("Torque (mN m)"), "Torque|mN m|");
    EXPECT_EQ(parts("Torque (smooth) [mN m]"), "Torque (smooth)|mN m|");
    EXPECT_EQ(parts("rate (1/(s))"), "rate|1/(s)|");
    EXPECT_EQ(parts("Gap in mm"), "Gap|mm|");
    EXPECT_EQ(parts("stress_ratio"), "stress_ratio||");
    EXPECT_EQ(parts("shear_stress_sd [Pa]"), "shear_stress|Pa|sd");
    EXPECT_EQ(parts("Shear stress std (Pa)"), "Shear stress|Pa|sd");
    EXPECT_EQ(parts("sd"), "sd||");
    EXPECT_EQ(parts("shear_stress_se [Pa]"), "shear_stress|Pa|se");
    EXPECT_EQ(parts("shear_stress uncertainty"), "shear_stress||se");
    EXPECT_EQ(parts("shear_stress_u95"), "shear_stress||u95");
}

TEST(HeaderCell, HasAMarkOfErrorsAtEitherEndInSeveralLanguages) {
    const auto parts = [](const char* text) {
        const HeaderCell cell = parse_header_cell(text);
        return fmt::format("{}|{}|{}", cell.name, cell.unit, suffix_of(cell.mark));
    };
    EXPECT_EQ(parts("sd shear stress [Pa]"), "shear stress|Pa|_sd");
    EXPECT_EQ(parts("Error of the shear stress (kPa)"), "shear stress|kPa|_se");
    EXPECT_EQ(parts("u(solid fraction)"), "solid fraction||_se");
    EXPECT_EQ(parts("u(shear stress) / kPa"), "shear stress|kPa|_se");
    EXPECT_EQ(parts("u(shear stress / kPa)"), "shear stress|kPa|_se");
    EXPECT_EQ(parts("± shear stress [Pa]"), "shear stress|Pa|_se");
    EXPECT_EQ(parts("Schubspannung ± [Pa]"), "Schubspannung|Pa|_se");
    EXPECT_EQ(parts("Fehler der Schubspannung [Pa]"), "Schubspannung|Pa|_se");
    EXPECT_EQ(parts("Schubspannung Standardabweichung [Pa]"), "Schubspannung|Pa|_sd");
    EXPECT_EQ(parts("Incertitude de la contrainte de cisaillement [Pa]"),
              "contrainte de cisaillement|Pa|_se");
    EXPECT_EQ(parts("Écart-type contrainte de cisaillement [Pa]"),
              "contrainte de cisaillement|Pa|_sd");
    EXPECT_EQ(parts("Desviación estándar del par [mNm]"), "par|mNm|_sd");
    // Neither a mark nor the errors of anything.
    EXPECT_EQ(parts("Error code"), "Error code||");
    EXPECT_EQ(parts("Set torque [mNm]"), "Set torque|mNm|");
    EXPECT_EQ(parts("u (m/s)"), "u|m/s|");
}

class ColumnsOf : public testing::Test {
  protected:
    const Columns& read(const std::string& content) {
        table_ = read_table(folder_.write("t.csv", content));
        columns_.emplace(table_);
        return *columns_;
    }
    std::string error(const std::string& content, const char* name) {
        return input_error([&] { read(content).require(name); });
    }
    const Row& row(std::size_t i = 0) const { return table_.rows.at(i); }

    TemporaryFolder folder_;
    Table table_;
    std::optional<Columns> columns_;
};

TEST_F(ColumnsOf, ConvertToSiInAnyOrderAndUnit) {
    const Columns& columns = read("Gap [mm];Torque (mNm);Time in min;M_extra\n20;3;2;7\n");
    EXPECT_DOUBLE_EQ(columns.value(row(), "height"), 0.02);
    EXPECT_DOUBLE_EQ(columns.value(row(), "torque"), 3e-3);
    EXPECT_DOUBLE_EQ(columns.value(row(), "time"), 120);
    EXPECT_THAT(columns.others({"time", "torque"}), ElementsAre("Gap [mm]", "M_extra"));
}

TEST_F(ColumnsOf, GiveDeviationsTheUnitOfTheirValue) {
    const Columns& columns = read("shear_stress_sd,shear_stress [kPa]\n0.01,0.25\n,0.3\n");
    EXPECT_DOUBLE_EQ(*columns.standard_error(row(), "shear_stress"), 10);
    EXPECT_EQ(columns.standard_error(row(1), "shear_stress"), std::nullopt);
    EXPECT_EQ(columns.standard_error(row(), "torque"), std::nullopt);
}

TEST_F(ColumnsOf, FindErrorsOfTranslatedNamesAndBehindTheirValues) {
    const auto names = [&](const std::string& header) {
        Table table = read_table(folder_.write("t.csv", header + "\n1;2;3;4\n"));
        use_names_of_quantities(table.header);
        std::vector<std::string> all;
        for (const Cell& cell : table.header.cells)
            all.push_back(cell.text);
        return all;
    };
    EXPECT_THAT(names("Schubspannung [kPa];Fehler Schubspannung [Pa];Feststoffanteil;±"),
                ElementsAre("shear_stress [kPa]", "shear_stress_se [Pa]", "solid_fraction",
                            "solid_fraction_se"));
    EXPECT_THAT(names("Schubspannung [kPa];±;Feststoffanteil;±"),
                ElementsAre("shear_stress [kPa]", "shear_stress_se", "solid_fraction",
                            "solid_fraction_se"));
    EXPECT_THAT(names("Contrainte de cisaillement [Pa];Incertitude [Pa];phi;Incertitude"),
                ElementsAre("shear_stress [Pa]", "shear_stress_se [Pa]", "phi", "phi_se"));
    EXPECT_THAT(names("Torque [mNm];error [uNm];Gap [mm];Error"),
                ElementsAre("Torque [mNm]", "Torque_se [uNm]", "Gap [mm]", "Error"))
        << "an error without a unit may be the code of a fault";
    EXPECT_THAT(names("shear_stress [Pa];Torque [mNm];sd [Pa];x"),
                ElementsAre("shear_stress [Pa]", "Torque [mNm]", "sd [Pa]", "x"))
        << "a torque has no error in Pa";
}

/// "SD" and "Std" may stand for other things than errors: letters of a test, and hours.
TEST(BareMarks, AreErrorsWhereTheyHoldSome) {
    const TemporaryFolder folder;
    const auto has_errors = [&](const std::string& mark, const std::string& cells) {
        std::string text = "Normal stress [Pa];Shear stress [Pa];" + mark + "\n";
        for (std::size_t i = 0; i < cells.size(); ++i)
            text += fmt::format("{};{};{}\n", 1000 * (i + 1), 200 + 510 * (i + 1), cells[i]);
        const BlockFile file = read_blocks(folder.write("t.csv", text));
        return file.blocks.at(0).columns.at(2).of_errors;
    };
    EXPECT_TRUE(has_errors("SD", "7986"));
    EXPECT_TRUE(has_errors("SE", "5555"));
    EXPECT_TRUE(has_errors("±", "2468")) << "2 % of loads at even distances";
    EXPECT_FALSE(has_errors("SD", "AABB"));
    EXPECT_FALSE(has_errors("SE", "NNNN"));
    EXPECT_FALSE(has_errors("Std", "1234"));
}

TEST_F(ColumnsOf, TranslateTheOtherInertialNumber) {
    const Columns& columns = read("inertial_number_diameter_density [1]\n0.01\n");
    EXPECT_DOUBLE_EQ(columns.value(row(), "inertial_number"),
                     0.01 / std::sqrt(6 / std::numbers::pi));
}

TEST_F(ColumnsOf, CountTurnsInASpeedAndRadiansInAnAngularVelocity) {
    const double turn = 2 * std::numbers::pi;
    EXPECT_DOUBLE_EQ(read("Speed [1/min]\n60\n").value(row(), "angular_velocity"), turn);
    EXPECT_DOUBLE_EQ(read("Angular velocity [rpm]\n60\n").value(row(), "angular_velocity"), turn);
    EXPECT_DOUBLE_EQ(read("Angular velocity [1/s]\n2\n").value(row(), "angular_velocity"), 2);
    EXPECT_DOUBLE_EQ(read("Angular velocity [Hz]\n1\n").value(row(), "angular_velocity"), turn);
    EXPECT_NEAR(read("Angular velocity [mHz]\n1000\n").value(row(), "angular_velocity"), turn,
                1e-12);
    EXPECT_NEAR(read("Angular velocity [deg/s]\n360\n").value(row(), "angular_velocity"), turn,
                1e-12);
    EXPECT_NEAR(read("Angular velocity [rad/min]\n60\n").value(row(), "angular_velocity"), 1,
                1e-12);
    EXPECT_DOUBLE_EQ(read("omega [rad/s]\n2\n").value(row(), "angular_velocity"), 2);
    expect_told({error("x,Angular velocity [1/min]\n1,60\n", "angular_velocity")});
}

TEST_F(ColumnsOf, RefuseAWrongUnitAtItsHeader) {
    expect_told({error("Time [s],Torque [g cm]\n1,2\n", "torque"),
                 error("Normal stress [pa]\n1\n", "normal_stress"),
                 error("Torque [bananas]\n1\n", "torque"), error("Torque\n1\n", "torque"),
                 error("Shear rate [rpm]\n1\n", "shear_rate")});
}

TEST_F(ColumnsOf, RefuseTwoColumnsOfOneQuantity) {
    expect_told({error("Gap [mm],Height [mm]\n1,2\n", "height")});
}

TEST_F(ColumnsOf, LeaveColumnsAloneThatNobodyNeeds) {
    const Columns& columns = read("Torque,Torque [kg],Gap [mm]\n1,2,3\n");
    EXPECT_DOUBLE_EQ(columns.value(row(), "height"), 3e-3);
}

TEST_F(ColumnsOf, NameAMissingColumnAndThoseFound) {
    const Columns& columns = read("Time [s],Gap [mm]\n1,2\n");
    expect_told({input_error([&] { columns.require("torque"); }), error("Time [s]\n1\n", "height"),
                 input_error([&] { columns.require_one_of("shear_stress", "stress_ratio"); })});
}

TEST_F(ColumnsOf, RefuseCellsThatAreNoNumbers) {
    const auto cell_error = [&](const std::string& text) {
        const Columns& columns = read("Time [s];Gap [mm]\n1;" + text + "\n2,5;3,5\n4,5;1\n");
        return input_error([&] { columns.value(row(), "height"); });
    };
    expect_told({cell_error("abc"), cell_error("nan"), cell_error("inf"), cell_error("1e999"),
                 cell_error("2 mm"), cell_error(""), cell_error("1,25")});
}

TEST_F(ColumnsOf, RefuseDeviationsThatAreNotPositive) {
    const Columns& columns = read("solid_fraction,solid_fraction_sd\n0.6,0\n");
    expect_told({input_error([&] { columns.standard_error(row(), "solid_fraction"); })});
}

// Digits to which the numbers of a column were rounded.
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

}  // namespace pendular::data_columns_test
