// Tables of points in whose columns two samples or levels stand one below the other, with words or
// numbers that may be taken for something else; set points, rejected rows and statistics.
#include <fmt/format.h>

#include "data/recordings/file_view.h"
#include "data/remarks/wording.h"
#include "tests/support/golden.h"

namespace pendular::data_groups_of_points_test {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::SizeIs;

FileView points(const std::string& text) {
    const TemporaryFolder folder;
    return view_of_file(folder.write("points.csv", text));
}

std::vector<double> cohesions(const FileView& view) {
    std::vector<double> result;
    for (const YieldLocus& locus : view.loci)
        result.push_back(locus.line ? locus.line->cohesion : -1);
    return result;
}

/// Points on 200 Pa + 0.6 s and on 400 Pa + 0.6 s, at the loads 1, 2 and 3 kPa and at others.
std::string two_groups(const std::string& name, const std::string& first, const std::string& second,
                       double other_loads = 1) {
    std::string text = name + ";Normal stress [kPa];Shear stress [kPa]\n";
    for (const double load : {1.0, 2.0, 3.0})
        text += fmt::format("{};{};{:.3f}\n", first, load, 0.2 + 0.6 * load);
    for (const double load : {1.0, 2.0, 3.0})
        text += fmt::format("{};{};{:.3f}\n", second, other_loads * load,
                            0.4 + 0.6 * other_loads * load);
    return text;
}

void expect_both(const FileView& view, const std::string& name) {
    EXPECT_THAT(cohesions(view), ElementsAre(DoubleNear(200, 1e-6), DoubleNear(400, 1e-6))) << name;
}

/// Each of these made the points of the second group preshears of the first.
TEST(Samples, AreNoPreshearsForTheirNames) {
    for (const auto& [name, first, second] :
         {std::tuple("Consolidation time [h]", "0", "24"), std::tuple("Preshear [kPa]", "0", "4"),
          std::tuple("Preshear displacement [mm]", "0", "20"),
          std::tuple("Anscherweg [mm]", "0", "8"), std::tuple("Presheared", "no", "yes"),
          std::tuple("Preconsolidated", "no", "yes"),
          std::tuple("Preparation", "loose", "consolidated"),
          std::tuple("Sample", "fresh", "presheared"), std::tuple("Preshear cycles", "0", "3")}) {
        const FileView view = points(two_groups(name, first, second));
        expect_both(view, name);
        for (const IntervalRole& role : view.roles)
            EXPECT_EQ(role.role, "failure") << name;
    }
}

/// With loads in proportion to the level none recurs, and all points made one line.
TEST(Levels, PartThePointsAtOtherLoadsToo) {
    for (const char* const name :
         {"Preshear [kPa]", "Preshear load [kPa]", "Consolidation load [kPa]", "Anscherlast [kPa]",
          "Vorlast [kPa]", "Precarga [kPa]", "Précisaillement [kPa]", "d50 [µm]", "Water [ml]"})
        expect_both(points(two_groups(name, "2", "4", 1.5)), name);
    const FileView levels = points(two_groups("Preshear [kPa]", "2", "4", 2));
    ASSERT_THAT(levels.loci, SizeIs(2));
    EXPECT_EQ(levels.loci[1].preshear->normal_stress, 4000);
}

TEST(ALevelOfZero, IsNoPreshear) {
    const FileView view = points(two_groups("Consolidation stress [kPa]", "0", "10"));
    expect_both(view, "0");
    EXPECT_FALSE(view.loci[0].preshear);
    EXPECT_TRUE(view.loci[1].preshear);
}

/// Merged cells of a spreadsheet leave all but their first row empty.
TEST(ConditionsNamedOnce, AreFilledDown) {
    expect_both(points("Water [ml];Normal stress [kPa];Shear stress [kPa]\n0;1;0.8\n;2;1.4\n;3;2\n"
                       "5;1;1\n;2;1.6\n;3;2.2\n"),
                "water");
    const FileView materials = points(
        "Material;Water [ml];Normal stress [kPa];Shear stress [kPa]\nGlass;0;1;0.8\n;;2;1.4\n"
        ";;3;2\n;5;1;1\n;;2;1.6\n;;3;2.2\nSand;0;1;0.9\n;;2;1.5\n;;3;2.1\n");
    EXPECT_THAT(cohesions(materials),
                ElementsAre(DoubleNear(200, 1e-6), DoubleNear(400, 1e-6), DoubleNear(300, 1e-6)));
}

TEST(MeasuredLoads, ComeBeforeTheirSetPoints) {
    for (const auto& [set, measured] :
         {std::pair("Nominal normal stress", "Actual normal stress"),
          std::pair("Applied normal stress", "Measured normal stress"),
          std::pair("Normalspannung", "Normalspannung gemessen")}) {
        const FileView view = points(fmt::format(
            "{} [kPa];{} [kPa];Shear stress [kPa]\n1;1.1;0.86\n2;2.2;1.52\n3;3.3;2.18\n", set,
            measured));
        ASSERT_THAT(view.loci, SizeIs(1)) << measured;
        EXPECT_THAT(view.loci[0].points.at(2).normal_stress, DoubleNear(3300, 1e-9)) << measured;
    }
}

TEST(RejectedRows, AreNoPoints) {
    for (const auto& [name, accepted, rejected] :
         {std::tuple("Valid", "yes", "no"), std::tuple("Bemerkung", "", "Ausreißer, verworfen"),
          std::tuple("Flag", "OK", "REJECT"), std::tuple("Excluded", "0", "1"),
          std::tuple("used for fit", "x", ""), std::tuple("Esito", "valida", "scartata"),
          std::tuple("Status", "", "overload")}) {
        std::string text = fmt::format("Normal stress [kPa];Shear stress [kPa];{}\n", name);
        for (const double load : {1.0, 2.0, 3.0, 4.0})
            text += fmt::format("{};{:.2f};{}\n", load, 0.2 + 0.6 * load, accepted);
        const FileView view = points(text + "2.5;5.9;" + rejected + "\n");
        EXPECT_THAT(cohesions(view), ElementsAre(DoubleNear(200, 1e-6))) << name;
        ASSERT_FALSE(view.file.skipped.empty()) << name;
        EXPECT_EQ(view.file.skipped.back().kind, Remark::Kind::marked_invalid);
    }
    // A surcharge is a load, and a deviation no outlier.
    EXPECT_THAT(points("Normal stress [kPa];Shear stress [kPa];Remarque\n1;0.8;surcharge 5 kPa\n"
                       "2;1.4;\n3;2.0;écart 2 %\n4;2.6;\n5;3.2;sobrecarga\n")
                    .loci.at(0)
                    .points,
                SizeIs(5));
    // Half of the rows, and words that do not reject.
    EXPECT_THAT(points("Normal stress [kPa];Shear stress [kPa];Valid\n1;0.8;yes\n2;1.4;no\n"
                       "3;2.0;no\n4;2.6;yes\n")
                    .loci.at(0)
                    .points,
                SizeIs(4));
    EXPECT_THAT(points("Normal stress [kPa];Shear stress [kPa];Remark\n1;0.8;no outlier\n2;1.4;\n"
                       "3;2.0;\n4;2.6;repeated\n")
                    .loci.at(0)
                    .points,
                SizeIs(4));
}

/// Statistics repeat the load of their points.
TEST(StatisticsOfEachLoad, AreNoPoints) {
    for (const auto& [mean, deviation] :
         {std::pair("MW", "StAbw"), std::pair("Ø", "SD"), std::pair("Avg 1 kPa", "SD 1 kPa")}) {
        std::string text = "Versuch;Normalspannung [kPa];Schubspannung [kPa]\n";
        for (const double load : {1.0, 2.0, 3.0})
            text += fmt::format("1;{0};{1:.3f}\n2;{0};{2:.3f}\n{3};{0};{4:.3f}\n{5};{0};0.014\n",
                                load, 0.21 + 0.6 * load, 0.19 + 0.6 * load, mean, 0.2 + 0.6 * load,
                                deviation);
        EXPECT_THAT(cohesions(points(text)),
                    ElementsAre(DoubleNear(210, 1e-6), DoubleNear(190, 1e-6)))
            << mean;
    }
}

}  // namespace pendular::data_groups_of_points_test
