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
    expect_told({run.output});
    EXPECT_EQ(run_pendular("import " + study).code, 0);
}

/// Groups of a table are of one material or of several: no study pools them in silence.
TEST(OwnFiles, BegunStudiesHoldOneGroupOfPoints) {
    const TemporaryFolder folder;
    const auto file =
        folder.write("points.csv",
                     "Matériau;Contrainte normale (kPa);Contrainte tangentielle (kPa)\n"
                     "Billes 1 mm;2;1.25\nBilles 1 mm;4;2.33\nBilles 1 mm;6;3.38\n"
                     "Billes/2 mm;2;1.375\nBilles/2 mm;4;2.563\nBilles/2 mm;6;3.718\n"
                     "eau, 2 %;2;1.475\neau, 2 %;4;2.663\neau, 2 %;6;3.818\n");
    const std::string study = (folder.path() / "study").string();
    const Outcome run = run_pendular("import " + file.string() + " --study " + study);
    ASSERT_EQ(run.code, 0) << run.errors;
    const std::string toml = content_of(study + "/study.toml");
    const std::size_t said = run.output.find("points.csv holds");
    ASSERT_NE(said, std::string::npos) << run.output;
    expect_told({run.output.substr(said, run.output.find('\n', said) - said), toml,
                 content_of(study + "/failure_Billes_2_mm.csv")});
    EXPECT_EQ(run_pendular("import " + study).code, 0);
    EXPECT_TRUE(std::filesystem::exists(study + "/failure_eau_2.csv"));
}

TEST(OwnFiles, DryGroupsOfAFileOnWaterStayDry) {
    const TemporaryFolder folder;
    const auto file =
        folder.write("wasser.csv",
                     "Normalspannung [kPa];Schubspannung trocken [kPa];Schubspannung 1 % Wasser "
                     "[kPa]\n2;1.25;1.55\n4;2.33;2.63\n6;3.38;3.68\n");
    const std::string study = (folder.path() / "study").string();
    ASSERT_EQ(run_pendular("import " + file.string() + " --study " + study).code, 0);
    const std::string toml = content_of(study + "/study.toml");
    EXPECT_NE(toml.find("\nliquid_content = 0 "), std::string::npos) << toml;
    EXPECT_NE(toml.find("\n# liquid_content = 0.025 "), std::string::npos) << toml;
}

/// Rows of the points of failure in a begun study, without the header.
std::string failures_of(const std::string& table, std::string* toml = nullptr) {
    const TemporaryFolder folder;
    const std::string file = folder.write("points.csv", table).string(),
                      study = (folder.path() / "study").string();
    EXPECT_EQ(run_pendular("import " + file + " --study " + study).code, 0);
    if (toml) *toml = content_of(study + "/study.toml");
    return content_of(study + "/failure.csv");
}

TEST(OwnFiles, BegunStudiesKeepStatedErrors) {
    std::string toml;
    EXPECT_THAT(failures_of("Normal stress [kPa];Shear stress [kPa];Shear stress_sd [kPa]\n"
                            "2;1.25;0.03\n4;2.33;0.05\n6;3.38;0.06\n",
                            &toml),
                AllOf(HasSubstr("2000,1250,30,"), HasSubstr("6000,3380,60,")));
    EXPECT_THAT(toml, Not(HasSubstr("no errors")));
    EXPECT_THAT(
        failures_of("Normal stress [kPa];Shear stress [kPa]\n2;1.25\n4;2.33\n6;3.38\n", &toml),
        HasSubstr("2000,1250,12.5,"));
    EXPECT_THAT(toml, HasSubstr("GUESS: no errors are stated, and shear_stress_se is 1 %"));
}

TEST(ImportFile, RefusesOneFileForTwoTablesOrTwice) {
    const TemporaryFolder folder;
    const std::string file = folder.write("points.csv", two_preshears).string(),
                      both = (folder.path() / "both.csv").string();
    const Outcome tables = run_pendular("import " + file + " --tidy " + both + " --loci " +
                                        (folder.path() / "." / "both.csv").string());
    EXPECT_EQ(tables.code, 2);
    EXPECT_FALSE(std::filesystem::exists(both));
    const Outcome twice = run_pendular("import " + file + " " + file);
    EXPECT_EQ(twice.code, 2);
    expect_told({tables.errors, twice.errors});
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
    expect_told({run.output});
}

TEST(ImportFile, CallsForcesOnALeverSo) {
    const TemporaryFolder folder;
    std::string text = "Time [s],Lever force [N],Normal force [N],Gap [mm],Speed [rpm]\n";
    for (int i = 0; i < 30; ++i)
        text += fmt::format("{},2,20,6.2,5\n", i);
    expect_told({run_pendular("import " + folder.write("t.csv", text).string()).output});
}

/// Rows of a home-built ring shear tester in Polish, with two speeds.
std::string rows_in_polish(const std::string& unit_of_speed) {
    std::string text = fmt::format(
        "Reometr\nPróbka:\tkulki\n\nCzas\tMoment obrotowy\tSiła normalna\tSzczelina\tPrędkość "
        "obrotowa\tOdcinek\n[s]\t[mN·m]\t[N]\t[mm]\t[{}]\t[-]\n",
        unit_of_speed);
    for (int i = 0; i < 120; ++i)
        text += fmt::format("{},0\t20,{}\t5,0\t17,{}\t{},00\t{}\n", i, i * i % 7, i % 5,
                            i < 60 ? 60 : 180, i < 60 ? 1 : 2);
    return text;
}

/// A missing quantity is told with the line to write, and the next command is complete.
TEST(ImportFile, NamesAColumnInAnUnknownUnitAndKeepsTheOptions) {
    const TemporaryFolder folder;
    const std::string rows = rows_in_polish("xq/min");
    const auto named = folder.write("a.txt", rows);
    const Outcome refused = run_pendular("import " + named.string());
    const Outcome read = run_pendular(
        "import " + named.string() +
        " --decimal , --columns '{ rotational_speed = \"Prędkość obrotowa [1/min]\" }'");
    EXPECT_EQ(read.code, 0) << read.errors;
    // Of an unknown name and beside columns that are read by their units.
    std::string other = rows;
    for (const auto& [from, to] :
         {std::pair("Prędkość obrotowa", "Silnik"), std::pair("Szczelina", "Dno"),
          std::pair("Czas", "Zegar"), std::pair("Siła normalna", "Czujnik")})
        other.replace(other.find(from), std::string_view(from).size(), to);
    const Outcome missing = run_pendular("import " + folder.write("b.txt", other).string());
    EXPECT_EQ(missing.code, 2);
    const Outcome no_study = run_pendular("import " + (folder.path() / "b.txt").string() +
                                          " --study " + (folder.path() / "study").string());
    expect_told({refused.errors, read.output, missing.output, no_study.errors});
}

/// All files of a folder begin a study, but for those that are no measurements, which are named.
TEST(BegunStudy, TakesAllFilesOfAFolder) {
    const TemporaryFolder folder;
    const auto files = folder.path() / "files", study = folder.path() / "study",
               named = folder.path() / "named";
    std::filesystem::create_directory(files);
    for (const char* const name : {"files/suche_1.txt", "files/suche_10.txt", "files/suche_2.txt"})
        folder.write(name, rows_in_polish("obr/min"));
    folder.write("files/CZYTAJ.txt", "Kulki szklane.\n");
    const Outcome no_study = run_pendular("import " + files.string() + " --decimal ,");
    const Outcome run = run_pendular("import " + files.string() + " --study " + study.string());
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.errors + run.output, HasSubstr("CZYTAJ.txt"));
    const std::string text = content_of(study / "study.toml");
    const auto at = [&](const char* name) { return text.find(fmt::format("file = \"{}\"", name)); };
    EXPECT_LT(at("suche_1.txt"), at("suche_2.txt"));
    EXPECT_LT(at("suche_2.txt"), at("suche_10.txt"));
    EXPECT_NE(at("suche_10.txt"), std::string::npos);
    EXPECT_THAT(text, HasSubstr("# surface_tension ="));
    // As the shell gives them.
    EXPECT_EQ(run_pendular("import " + files.string() + "/*.txt --study " + named.string()).code,
              0);
    for (const char* const name : {"suche_1.txt", "suche_2.txt", "suche_10.txt"})
        EXPECT_THAT(content_of(named / "study.toml"), HasSubstr(name));
    // A file that is named is meant: where it cannot be read, none is.
    folder.write("files/torn.csv", "Time [s],Torque [mN m]\n0,20\n1,x\n2,20\n3,20\n4,20\n");
    const Outcome torn = run_pendular("import " + files.string() + "/*.* --study " +
                                      (folder.path() / "torn").string());
    EXPECT_EQ(torn.code, 2);
    expect_told({no_study.errors, torn.errors});
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "torn"));
    // A file with nothing in it, as after a full disk, is no note.
    std::filesystem::remove(files / "torn.csv");
    folder.write("files/none.csv", "");
    const Outcome none = run_pendular("import " + files.string() + "/*.* --study " +
                                      (folder.path() / "none").string());
    EXPECT_EQ(none.code, 2);
    EXPECT_THAT(none.errors, HasSubstr("none.csv"));
}

/// Many files are a line each; a folder without any is said to be one.
TEST(ImportedFolder, IsALineForEachOfManyFiles) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path() / "files");
    std::string names;
    for (int i = 1; i <= 5; ++i)
        names +=
            " " +
            folder.write(fmt::format("files/lauf_{}.txt", i), rows_in_polish("obr/min")).string();
    const Outcome run = run_pendular("import" + names);
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_LT(std::ranges::count(run.output, '\n'), 10) << run.output;  // next command too
    std::filesystem::create_directory(folder.path() / "empty");
    const Outcome empty = run_pendular("import " + (folder.path() / "empty").string() +
                                       " --study " + (folder.path() / "study").string());
    EXPECT_EQ(empty.code, 2);
    expect_told({empty.errors});
}

/// Names in study.toml are as the user would write them.
TEST(BegunStudy, HasNamesInTheirOwnLetters) {
    const TemporaryFolder folder;
    const auto file = folder.write("ż.txt", rows_in_polish("xq/min")),
               study = folder.path() / "study";
    const std::string columns = "{ rotational_speed = \"Prędkość obrotowa [rpm]\" }";
    ASSERT_EQ(run_pendular("import " + file.string() + " --columns '" + columns + "' --study " +
                           study.string())
                  .code,
              0);
    EXPECT_THAT(content_of(study / "study.toml"),
                AllOf(HasSubstr("file = \"ż.txt\""), HasSubstr("columns = " + columns)));
}

/// A study with files that are called wet in any language begins with a liquid to be filled in.
TEST(BegunStudy, HasALiquidWhereAFileIsCalledWet) {
    const TemporaryFolder folder;
    std::string text = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]\n";
    for (int i = 0; i < 30; ++i)
        text += fmt::format("{},2{},20,6.2{},5\n", i, i % 7, i % 3);
    const std::string dry = folder.write("secco.csv", text).string() + " ";
    for (const char* const wet :
         {"umido_3", "feucht 2 %", "Nass1", "mouillé", "arena_húmeda", "glass_w10_3kPa",
          "moist-sand", "mokre_A", "Öl_A", "O\u0308l_B"}) {
        const std::filesystem::path study = folder.path() / (std::string(wet) + "_study");
        const Outcome run = run_pendular("import " + dry + "'" +
                                         folder.write(std::string(wet) + ".csv", text).string() +
                                         "' --study '" + study.string() + "'");
        ASSERT_EQ(run.code, 0) << run.errors;
        EXPECT_THAT(content_of(study / "study.toml"), HasSubstr("\n[liquid]\nsurface_tension"))
            << wet;
    }
    for (const char* const other : {"wall_without", "niveau", "umidita", "nat_sand"}) {
        const std::filesystem::path study = folder.path() / (std::string(other) + "_study");
        run_pendular("import " + dry + folder.write(std::string(other) + ".csv", text).string() +
                     " --study " + study.string());
        EXPECT_THAT(content_of(study / "study.toml"), Not(HasSubstr("\n[liquid]"))) << other;
    }
}

/// Wet grains never count as dry for a column that nobody asks for.
TEST(BegunStudy, HasTheLiquidContentOfAColumnOrOfALineAbove) {
    const TemporaryFolder folder;
    const auto recording = [](const std::string& above, const std::string& cells) {
        std::string text = above + "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]" +
                           (cells.empty() ? "" : ",Liquid content [%]") + "\n";
        for (int i = 0; i < 30; ++i)
            text += fmt::format("{},2{},20,6.2{},5{}\n", i, i % 7, i % 3, cells);
        return text;
    };
    const std::string study = (folder.path() / "study").string();
    const auto begun = [&](const std::string& text) {
        std::filesystem::remove_all(study);
        const auto file = folder.write("glass.csv", text);
        EXPECT_EQ(run_pendular("import " + file.string() + " --study " + study).code, 0);
        return content_of(study + "/study.toml");
    };
    const std::string column = begun(recording("", ",1"));
    EXPECT_THAT(column, AllOf(HasSubstr("\n[liquid]\n"), HasSubstr("\nliquid_content = 0.01 ")));
    EXPECT_THAT(begun(recording("Teneur en liquide : 2 %\n\n", "")),
                AllOf(HasSubstr("\nliquid_content = 0.02 "), HasSubstr("fit_to = \"all\"")));
    EXPECT_THAT(begun(recording("Water content: 2 %\n\n", "")),
                HasSubstr("\nliquid_content = 0.05 "));
    const std::string dry = begun(recording("Bead diameter: 1 mm\nBead mass: 120 g\n\n", ",0"));
    EXPECT_THAT(dry, AllOf(HasSubstr("diameter = \"1000 um\""), HasSubstr("bead_mass = \"120 g\""),
                           Not(HasSubstr("\n[liquid]"))));
    // A study that leaves the content out is refused.
    begun(recording("", ",1"));
    folder.write("study/study.toml", dry);
    const Outcome refused = run_pendular("import " + study);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("has the liquid content 0.01 in the column"));
}

/// Columns without a unit of their own, or with a mass for a force, are named with the line to
/// write; a factor beside a name is why its column is not read.
TEST(ImportFile, NamesColumnsThatMayBeWhatIsMissing) {
    const TemporaryFolder folder;
    const auto told = [&](const std::string& header) {
        std::string text = header + "\n";
        for (int i = 0; i < 30; ++i)
            text += fmt::format("{};0.95;5.0{};2{}.1;12.0{}\n", i, i % 7, i % 5, i % 3);
        return run_pendular("import " + folder.write("t.csv", text).string()).output;
    };
    EXPECT_THAT(told("millis;rpm;load_g;torque_mNm;gap_mm"),
                AllOf(HasSubstr("columns = { time = \"millis [ms]\" }"),
                      HasSubstr("columns = { rotational_speed = \"rpm [rpm]\" }"),
                      HasSubstr("columns = { normal_force = \"load_g [gf]\" }"),
                      Not(HasSubstr("Export these columns too"))));
    EXPECT_THAT(told("t_us;n_tr_min;F_daN;C_Nm;e_mm"),
                AllOf(HasSubstr("columns = { normal_force = \"F_daN [daN]\" }"),
                      HasSubstr("columns = { torque = \"C_Nm [Nm]\" }"),
                      HasSubstr("columns = { height = \"e_mm [mm]\" }")));
    EXPECT_THAT(told("Tempo (s);Speed (rpm);Carico (kg);Coppia (mNm);Altezza (mm)"),
                AllOf(HasSubstr("did you mean 'kgf'?"),
                      HasSubstr("columns = { normal_force = \"Carico [kgf]\" }")));
    EXPECT_THAT(told("Time [s];Angle [°];Normal force [N];Torque [mNm];Gap [mm]"),
                HasSubstr("No speed is computed from the column 'Angle'"));
    EXPECT_THAT(told("Time [s];Speed [rpm];Normal force [N];1000 × Couple [mNm];Gap [mm]"),
                HasSubstr("Column '1000 × Couple [mNm]' is not used, since its name has a factor"));
    const Outcome refused = run_pendular(
        "import " + folder
                        .write("s.csv",
                               "Contrainte normale [kg/cm²];Contrainte de cisaillement "
                               "[kg/cm²]\n1;0.6\n2;1.2\n3;1.8\n4;2.3\n")
                        .string());
    EXPECT_THAT(refused.errors, HasSubstr("did you mean 'kgf/cm²'?"));
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
    const std::string angle = fmt::format(",{:.6g},", std::atan(0.3) * 180 / std::numbers::pi);
    EXPECT_THAT(content_of(loci), HasSubstr(angle));
    EXPECT_THAT(content_of(figures / "wall_locus_1.csv"), HasSubstr("wall yield locus,0,100"));
    const Outcome below =
        run_pendular("import " + folder.write("below.csv", wall_points(-100, 2)).string());
    expect_told({run.output, below.output});
}

TEST(YieldLoci, ExactlyOnAWallLineStateNoError) {
    const TemporaryFolder folder;
    for (const double adhesion : {0, 100}) {
        const auto file = folder.write("wall.csv", wall_points(adhesion, 0));
        expect_told({run_pendular("import " + file.string()).output});
    }
}

}  // namespace app_import_tables_test
