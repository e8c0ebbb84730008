// Kinds of tests other than shear at constant speed.
#include "data/recordings/test_kinds.h"

#include <cmath>
#include <tuple>

#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "data/recordings/yield_locus.h"
#include "data/remarks/wording.h"
#include "tests/support/golden.h"

namespace pendular::data_test_kinds_test {

using testing::Each;
using testing::ElementsAre;

std::vector<std::string> told_roles(const FileView& view) {
    std::vector<std::string> roles;
    for (const IntervalRole& role : view.roles)
        roles.push_back(role.role + ": " + role.reason);
    return roles;
}

std::string recording(const std::string& more_header, const std::string& more_cell,
                      double force_at_end = 5) {
    std::string text = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s]" +
                       more_header + "\n";
    for (int i = 0; i < 60; ++i)
        text +=
            fmt::format("{},20,{},6.2,0.5{}\n", i, 5 + (force_at_end - 5) * i / 59.0, more_cell);
    return text;
}

TEST(KindsOfTest, StepsOfTheLoadAreNoRamp) {
    const TemporaryFolder folder;
    std::string steps =
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s]\n";
    for (int i = 0; i < 90; ++i) {
        const double force = 5 * std::pow(3, i / 30);
        steps += fmt::format("{},{},{},6.2,0.5\n", i, 4 * force, force * (1 + 0.002 * (i % 3)));
    }
    const auto role_of = [&](const std::string& text) {
        return view_of_file(folder.write("t.csv", text)).roles.at(0).role;
    };
    EXPECT_EQ(role_of(steps), "steady");
    EXPECT_NE(role_of(recording("", "", 45)), "steady");
}

TEST(KindsOfTest, AreShownByColumns) {
    const TemporaryFolder folder;
    const auto told = [&](const std::string& text) {
        return told_roles(view_of_file(folder.write("t.csv", text))).at(0);
    };
    expect_told({told(recording(",Storage Modulus [Pa]", ",1200")),
                 told(recording(",Frequenz [Hz]", ",1")),  // of the motor: the lid turns
                 told(recording(",Creep Compliance [1/Pa]", ",1e-3")), told(recording("", "", 10)),
                 told(recording("", "")), told(recording(",Storage Modulus [Pa]", ",")),
                 told(recording(",Storage Modulus [Pa]", ",---")),
                 told(recording(",Storage Modulus [Pa]", ",NaN")),
                 told(recording(",Storage Modulus [Pa]", ",0"))});
}

TEST(KindsOfTest, AreLeftOutOfAStudy) {
    const TemporaryFolder folder;
    const auto path = folder.write("t.csv", recording(",Storage Modulus [Pa]", ",1200"));
    EXPECT_FALSE(quick_recording(path, {}));
    const Recording all = read_recording(path);
    EXPECT_EQ(all.size(), 0u);
    ASSERT_EQ(all.left_out.size(), 1u);
    EXPECT_EQ(all.left_out[0].kind, Remark::Kind::other_test);
    EXPECT_EQ(all.left_out[0].lines[0], (Lines{2, 61, 0}));
    expect_told({text_of(all.left_out[0])});
    // Zeros are no moduli, and an interval without any is kept.
    EXPECT_EQ(
        read_recording(folder.write("z.csv", recording(",Storage Modulus [Pa]", ",0"))).size(),
        60u);
    std::string two =
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm],Interval,"
        "Storage Modulus [Pa]\n";
    for (int i = 0; i < 40; ++i)
        two += fmt::format("{},20,5,6.2,5,{},{}\n", i, i < 20 ? 1 : 2, i < 20 ? 0 : 1200);
    const Recording first = read_recording(folder.write("two.csv", two));
    EXPECT_EQ(first.size(), 20u);
    EXPECT_THAT(first.interval, Each(1));
    // The user may say that it is steady shear.
    FileFormat format;
    format.roles["steady"] = {"2"};
    EXPECT_EQ(read_recording(folder.path() / "two.csv", format).size(), 40u);
}

TEST(KindsOfTest, AreShownByAFrequencyWithoutASpeed) {
    const TemporaryFolder folder;
    std::string text = "Time [s],Angular Frequency [rad/s],Shear stress [Pa],Normal stress [Pa]\n";
    for (int i = 0; i < 5; ++i)
        text += fmt::format("{},{},30,60\n", i, 1 + i);
    expect_told(told_roles(view_of_file(folder.write("t.csv", text))));
}

TEST(TableOfPoints, StatesItsPreshear) {
    const TemporaryFolder folder;
    // As Schulze writes the results of ring shear testers: two levels of preshear.
    std::string text = "sigma pre [Pa],tau pre [Pa],Normal stress [Pa],Shear stress [Pa]\n";
    for (const double pre : {2000.0, 4000.0})
        for (const double part : {0.25, 0.5, 0.75})
            text += fmt::format("{},{},{},{}\n", pre, 0.5 * pre, part * pre,
                                0.1 * pre + 0.4 * part * pre);
    const FileView view = view_of_file(folder.write("locus.csv", text));
    ASSERT_EQ(view.loci.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        // c = 0.1 p and tan(phi) = 0.4 scale with the preshear p, and so does all else.
        EXPECT_NEAR(view.loci[k].line->cohesion, k == 0 ? 200 : 400, 1e-9);
        EXPECT_NEAR(view.loci[k].preshear->normal_stress, k == 0 ? 2000 : 4000, 1e-9);
        ASSERT_TRUE(view.loci[k].line->flowability);
    }
    EXPECT_NEAR(*view.loci[0].line->flowability, *view.loci[1].line->flowability, 1e-9);
    // The normal stress alone divides the points, but gives no Mohr circle.
    std::string less = "sigma pre [Pa],Normal stress [Pa],Shear stress [Pa]\n";
    for (const double part : {0.25, 0.5, 0.75})
        less += fmt::format("2000,{},{}\n", part * 2000, 200 + 0.4 * part * 2000);
    const FileView without = view_of_file(folder.write("less.csv", less));
    ASSERT_EQ(without.loci.size(), 1u);
    EXPECT_FALSE(without.loci[0].line->flowability);
}

TEST(TableOfPoints, IsOneTestInEachRow) {
    const TemporaryFolder folder;
    // On the line 53 Pa + 0.512 s.
    std::string text = "Normal stress [Pa]\tShear stress [Pa]\n";
    for (const double s : {438.0, 442.0, 880.0, 1320.0, 2200.0})
        text += fmt::format("{}\t{}\n", s, 53 + 0.512 * s);
    const FileView view = view_of_file(folder.write("peaks.txt", text));
    EXPECT_EQ(view.roles.size(), 5u);
    EXPECT_THAT(told_roles(view), Each(testing::StartsWith("failure")));
    ASSERT_EQ(view.loci.size(), 1u);
    EXPECT_NEAR(view.loci[0].line->cohesion, 53, 1e-9);
    EXPECT_NEAR(std::tan(view.loci[0].line->slope_angle), 0.512, 1e-12);
    // Steps of a recording without time, of many rows each, are none.
    std::string steps = "Normal stress [Pa],Shear stress [Pa]\n";
    for (const double s : {500.0, 1000.0, 2000.0})
        for (int i = 0; i < 20; ++i)
            steps += fmt::format("{},{}\n", s, 0.5 * s);
    EXPECT_EQ(view_of_file(folder.write("steps.csv", steps)).roles.size(), 1u);
}

TEST(TableOfPoints, HasNoColumnThatReadingsOfSteadyShearHave) {
    const TemporaryFolder folder;
    const auto blocks = [&](const std::string& column) {
        std::string text = "Normal stress [Pa],Shear stress [Pa]," + column + "\n";
        for (const double s : {500.0, 1000.0, 2000.0, 4000.0})
            text += fmt::format("{},{},0.6\n", s, 0.5 * s);
        return view_of_file(folder.write("t.csv", text)).file.table_of_points;
    };
    EXPECT_TRUE(blocks("Humidity [1]"));
    EXPECT_TRUE(blocks("Bulk density [g/cm^3]"));  // as shear testers measure it
    for (const std::string column : {"Solid fraction", "Shear rate [1/s]", "Shear velocity [mm/s]",
                                     "Gap [mm]", "Inertial number"})
        EXPECT_FALSE(blocks(column)) << column;
}

TEST(LinearYieldLocus, HasErrorsFromTheScatterOfItsPoints) {
    // Residuals +1, -1, -1, +1 about 100 + 0.5 s at s = 0, 1000, 2000, 3000: they are orthogonal to
    // 1 and s, so that the line is 100 + 0.5 s. The variance is 4/(4 - 2) = 2; with mean 1500 and
    // squares 5e6, var(slope) = 2/5e6 and var(intercept) = 2 (1/4 + 1500^2/5e6) = 1.4.
    const std::vector<double> s = {0, 1000, 2000, 3000}, t = {101, 599, 1099, 1601};
    const LinearYieldLocus locus = linear_yield_locus(s, t, PreshearPoint{4000, 2100});
    ASSERT_TRUE(locus.errors);
    EXPECT_NEAR(locus.errors->cohesion, std::sqrt(1.4), 1e-9);
    const double slope_error = std::sqrt(2 / 5e6);
    EXPECT_NEAR(locus.errors->slope_angle, slope_error / 1.25, 1e-6 * slope_error);  // d atan
    // fc = 2 c (m + sqrt(1 + m^2)) with m the slope: cos/(1 - sin) of atan(m).
    const double root = std::sqrt(1.25), by_c = 2 * (0.5 + root), by_m = 2 * 100 * (1 + 0.5 / root),
                 both = -2.0 * 1500 / 5e6;
    EXPECT_NEAR(locus.errors->unconfined_strength,
                std::sqrt(by_c * by_c * 1.4 + by_m * by_m * 2 / 5e6 + 2 * by_c * by_m * both),
                1e-6);
    EXPECT_GT(locus.errors->major_principal_stress, 0);
    EXPECT_GT(locus.errors->flowability, 0);
    EXPECT_FALSE(linear_yield_locus({0, 1000, 2000}, {101, 599, 1101}, {}).errors);
}

/// Ten drops far beyond the noise are a sawtooth, though ten sudden changes of noise in one sense
/// are no rare event.
TEST(StickSlipTest, IsCertainWithFewDrops) {
    const auto saw = [](int period, double least, double greatest, int rows) {
        IntervalSeries series;
        for (int i = 0; i < rows; ++i) {
            series.time.push_back(i);
            series.torque.push_back(least + (greatest - least) * (i % period) / period +
                                    2e-4 * std::sin(i * 12.9898));
        }
        return series;
    };
    for (const auto& [period, least, greatest, rows] :
         {std::tuple(40, 0.04, 0.08, 400), std::tuple(100, 0.05, 0.075, 1000),
          std::tuple(30, 0.05, 0.07, 300), std::tuple(60, 0.04, 0.08, 600)}) {
        const auto told = stick_slip(saw(period, least, greatest, rows));
        ASSERT_TRUE(told) << period;
        EXPECT_NE(told->find(fmt::format("every {} rows", period)), std::string::npos) << *told;
    }
    // A single drop that comes back, and a fall in steps, are none.
    IntervalSeries other = saw(1000, 0.04, 0.08, 400);
    for (std::size_t i = 40; i < other.torque.size(); i += 40)
        other.torque[i] = 0.01;
    EXPECT_FALSE(stick_slip(other));
    for (std::size_t i = 0; i < other.torque.size(); ++i)
        other.torque[i] = 0.08 - 0.006 * static_cast<double>(i / 40) + 1e-4 * std::sin(i * 12.9898);
    EXPECT_FALSE(stick_slip(other));
}

TEST(WallFriction, IsNamedInMoreWords) {
    for (const char* const name :
         {"Essai de frottement aux parois", "Frottement poudre/paroi", "Friction pariétale",
          "Prova di attrito contro parete", "WFT 3", "wall coupon 316L"}) {
        BlockFile file;
        file.file = "t.csv";
        file.blocks.emplace_back().test = name;
        EXPECT_NE(shown_wall(file), "") << name;
    }
    BlockFile file;
    file.blocks.emplace_back().columns = {{"Contrainte pariétale", "kPa", "shear_stress"}};
    EXPECT_NE(shown_wall(file), "");
    file.blocks[0].columns = {{"Contrainte", "kPa", "shear_stress"}};
    file.blocks[0].test = "frottement interne, poudre";
    EXPECT_EQ(shown_wall(file), "");
}

TEST(WallFriction, IsTestedOnlyWhereALineNamesTheTest) {
    const auto shown = [](const std::string& key, const std::string& value) {
        BlockFile file;
        file.file = "t.csv";
        file.blocks.emplace_back();
        file.add_fact({key, value, 1});
        return !shown_wall(file).empty();
    };
    for (const char* const title :
         {"Cell with smooth side walls; no wall friction correction applied",
          "Consolidated at 5 kPa; wall friction angle 12°", "Steel lid, wall friction negligible",
          "Wall friction coefficient 0.3", "Without wall friction", "Keine Wandreibung",
          "Wall friction of the cell see file wf.csv", "Wandreibung vernachlässigt"})
        EXPECT_FALSE(shown("title", title)) << title;
    EXPECT_FALSE(shown("Wall friction of the cell", "see file wf.csv"));
    EXPECT_FALSE(shown("Wall friction", "0.3"));
    EXPECT_FALSE(shown("Wall friction angle", "12 deg"));
    for (const char* const title :
         {"Wall friction test no. 3", "Wandreibung Stahl", "Limestone, wall friction",
          "Limestone, test of wall friction on steel 316L", "Angolo d'attrito alla parete",
          "Wall friction test in a Jenike cell"})
        EXPECT_TRUE(shown("title", title)) << title;
    EXPECT_TRUE(shown("Test", "wall friction"));
    EXPECT_TRUE(shown("Wall friction test", "steel"));
}

TEST(WallFriction, IsThatOfTheTestsWithItsNameAlone) {
    BlockFile file;
    file.file = "t.csv";
    for (const char* const test : {"internal friction", "wall friction (steel)"})
        file.blocks.emplace_back().test = test;
    EXPECT_EQ(shown_wall(file), "");
    EXPECT_EQ(named_wall(file.blocks[0]), "");
    EXPECT_NE(named_wall(file.blocks[1]), "");
    const auto named = [&](const char* test) {
        file.blocks[0].test = test;
        return !named_wall(file.blocks[0]).empty();
    };
    for (const char* const test : {"wall steel", "Wall (steel)", "glass on steel wall", "Wand",
                                   "Sand auf Wand", "Sand-steel interface shear test"})
        EXPECT_TRUE(named(test)) << test;
    for (const char* const test : {"smooth wall", "sand, rough wall", "cell with steel wall",
                                   "glass on steel", "steel", "interface"})
        EXPECT_FALSE(named(test)) << test;
}

}  // namespace pendular::data_test_kinds_test
