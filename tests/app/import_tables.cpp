// Tables that `import` writes and takes, and what it says of files by their columns.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "tests/support/app_support.h"

namespace app_import_tables_test {

using pendular::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// Points of failure after two preshears, with scatter, bulk densities and unequal preshears.
const std::string two_preshears = [] {
    std::string text =
        "sigma pre [Pa],tau pre [Pa],Normal stress [Pa],Shear stress [Pa],Bulk density [kg/m^3]\n";
    for (const double pre : {2000.0, 4000.0})
        for (const int k : {1, 2, 3, 4})
            text += fmt::format("{},{},{},{},{}\n", pre, 0.55 * pre + k, 0.2 * k * pre,
                                0.1 * pre + 0.09 * k * pre + (k % 3 == 1 ? 2 : -2), 1400 + k);
    return text;
}();

/// Rows of a table of loci without file and test.
std::vector<std::string> results(const std::filesystem::path& table) {
    std::istringstream lines(content_of(table));
    std::vector<std::string> rows;
    for (std::string line; std::getline(lines, line);)
        rows.push_back(line.substr(line.find(',', line.find(',') + 1)));
    return rows;
}

TEST(OwnFiles, TidyTablesKeepYieldLoci) {
    const TemporaryFolder folder;
    const std::string tidy = (folder.path() / "tidy.csv").string();
    const auto before = folder.path() / "before.csv", after = folder.path() / "after.csv";
    const auto file = folder.write("points.csv", two_preshears);
    ASSERT_EQ(
        run_pendular("import " + file.string() + " --tidy " + tidy + " --loci " + before.string())
            .code,
        0);
    ASSERT_EQ(run_pendular("import " + tidy + " --loci " + after.string()).code, 0);
    EXPECT_EQ(results(before).size(), 3u);
    EXPECT_EQ(results(after), results(before));
}

TEST(OwnFiles, PointsOfFailureOfABegunStudySaySo) {
    const TemporaryFolder folder;
    const auto file = folder.write("points.csv", two_preshears);
    const std::string study = (folder.path() / "study").string();
    ASSERT_EQ(run_pendular("import " + file.string() + " --study " + study).code, 0);
    const Outcome run = run_pendular("import " + study + "/failure.csv");
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.output, AllOf(HasSubstr("a point of failure, as its column failure says"),
                                  HasSubstr("preshear with normal stress 4000 Pa"),
                                  Not(HasSubstr("steady  "))));
    EXPECT_EQ(run_pendular("import " + study).code, 0);
}

TEST(ImportFile, RefusesOneFileForTwoTablesOrTwice) {
    const TemporaryFolder folder;
    const std::string file = folder.write("points.csv", two_preshears).string(),
                      both = (folder.path() / "both.csv").string();
    const Outcome tables = run_pendular("import " + file + " --tidy " + both + " --loci " +
                                        (folder.path() / "." / "both.csv").string());
    EXPECT_EQ(tables.code, 2);
    EXPECT_THAT(tables.errors, HasSubstr("by --tidy and by --loci"));
    EXPECT_FALSE(std::filesystem::exists(both));
    const Outcome twice = run_pendular("import " + file + " " + file);
    EXPECT_EQ(twice.code, 2);
    EXPECT_THAT(twice.errors, HasSubstr("named twice"));
}

TEST(ImportFile, NamesEveryFileOfWhichNothingIsUsed) {
    const TemporaryFolder folder;
    std::string sweep =
        "Time [s],Storage Modulus [Pa],Loss Modulus [Pa],Shear stress [Pa],Normal stress [Pa]\n";
    std::string no_gap = "Time [s],Torque [mN m],Normal force [N],Speed [rpm]\n";
    for (int i = 0; i < 30; ++i) {
        sweep += fmt::format("{},1200,300,{},100\n", i, 50 + i);
        no_gap += fmt::format("{},20,5,5\n", i);
    }
    const Outcome run = run_pendular("import " + folder.write("a.csv", sweep).string() + " " +
                                     folder.write("b.csv", no_gap).string() + " " +
                                     folder.write("c.csv", sweep).string());
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.output, AllOf(StartsWith("Nothing of a.csv, c.csv is used: oscillation"),
                                  HasSubstr(" Nothing of b.csv is used: it has no gap.")));
}

TEST(ImportFile, CallsForcesOnALeverSo) {
    const TemporaryFolder folder;
    std::string text = "Time [s],Lever force [N],Normal force [N],Gap [mm],Speed [rpm]\n";
    for (int i = 0; i < 30; ++i)
        text += fmt::format("{},2,20,6.2,5\n", i);
    const Outcome run = run_pendular("import " + folder.write("t.csv", text).string());
    EXPECT_THAT(run.output, AllOf(HasSubstr("largest lever force [N]"), Not(HasSubstr("[Pa]"))));
}

/// A study with files that are called wet in any language begins with a liquid to be filled in.
TEST(BegunStudy, HasALiquidWhereAFileIsCalledWet) {
    const TemporaryFolder folder;
    std::string text = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]\n";
    for (int i = 0; i < 30; ++i)
        text += fmt::format("{},2{},20,6.2{},5\n", i, i % 7, i % 3);
    const std::string dry = folder.write("secco.csv", text).string() + " ";
    for (const char* const wet : {"umido_3", "feucht 2 %", "Nass1", "mouillé", "arena_húmeda",
                                  "glass_w10_3kPa", "moist-sand"}) {
        const std::filesystem::path study = folder.path() / (std::string(wet) + "_study");
        const Outcome run = run_pendular("import " + dry + "'" +
                                         folder.write(std::string(wet) + ".csv", text).string() +
                                         "' --study '" + study.string() + "'");
        ASSERT_EQ(run.code, 0) << run.errors;
        EXPECT_THAT(content_of(study / "study.toml"), HasSubstr("[liquid]\nsurface_tension"))
            << wet;
    }
    for (const char* const other : {"wall_without", "niveau", "umidita"}) {
        const std::filesystem::path study = folder.path() / (std::string(other) + "_study");
        run_pendular("import " + dry + folder.write(std::string(other) + ".csv", text).string() +
                     " --study " + study.string());
        EXPECT_THAT(content_of(study / "study.toml"), Not(HasSubstr("[liquid]"))) << other;
    }
}

std::string wall_points(double adhesion, double noise) {
    std::string text = "Wall normal stress [Pa],Wall shear stress [Pa]\n";
    for (const int k : {1, 2, 3, 4})
        text +=
            fmt::format("{},{}\n", 1000 * k, adhesion + 300 * k + (k % 3 == 1 ? 1 : -1) * noise);
    return text;
}

/// Text, lines for study.toml, table and figure of an adhering wall take one line.
TEST(YieldLoci, AlongAnAdheringWallAreOneLine) {
    const TemporaryFolder folder;
    const auto file = folder.write("wall.csv", wall_points(100, 2)), loci = folder.path() / "l.csv",
               figures = folder.path() / "figures";
    const Outcome run = run_pendular("import " + file.string() + " --loci " + loci.string() +
                                     " --figures " + figures.string());
    ASSERT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.output, AllOf(HasSubstr("value = 0.3\n"), HasSubstr("above zero")));
    const std::string angle = fmt::format(",{:.6g},", std::atan(0.3) * 180 / std::numbers::pi);
    EXPECT_THAT(content_of(loci), HasSubstr(angle));
    EXPECT_THAT(content_of(figures / "wall_locus_1.csv"), HasSubstr("wall yield locus,0,100"));
    const Outcome below =
        run_pendular("import " + folder.write("below.csv", wall_points(-100, 2)).string());
    EXPECT_THAT(below.output, HasSubstr("meets the axis below zero"));
}

TEST(YieldLoci, ExactlyOnAWallLineStateNoError) {
    const TemporaryFolder folder;
    for (const double adhesion : {0, 100}) {
        const Outcome run =
            run_pendular("import " + folder.write("wall.csv", wall_points(adhesion, 0)).string());
        EXPECT_THAT(run.output, AllOf(HasSubstr("error = 0.03   # GUESS: points exactly"),
                                      HasSubstr("value = 0.3\n")));
    }
}

}  // namespace app_import_tables_test
