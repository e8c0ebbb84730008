// What the program says of a single file of measurements, and the study that it begins.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>

#include "tests/support/app_support.h"

namespace app_import_file_test {

using pendular::TemporaryFolder;
using testing::HasSubstr;

const std::string look_alikes = PENDULAR_SOURCE_DIR "/tests/data/formats/";

TEST(ImportFile, SaysWhatTheFileIsUnderstoodAs) {
    const Outcome run = run_pendular("import " + look_alikes + "powder_cell_all.txt --all");
    EXPECT_EQ(run.code, 0) << run.errors;
    expect_told({run.output});
}

TEST(ImportFile, RefusesAFileWithWhatToWrite) {
    const Outcome units = run_pendular("import " + look_alikes + "no_units_damaged_torque.csv");
    EXPECT_EQ(units.code, 2);
    expect_told({units.errors});
    const Outcome stated = run_pendular(
        "import " + look_alikes +
        "no_units_damaged_torque.csv --columns 'Point [1]; Time [s]; Gap [mm]; Normal Force [N]; "
        "Normal Stress [Pa]; Torque [mN m]; Shear Stress [Pa]; Speed [1/min]'");
    EXPECT_EQ(stated.code, 0) << stated.errors;
    expect_told({stated.output});
    const Outcome layout = run_pendular("import " + look_alikes + "trios.csv --layout trois");
    EXPECT_EQ(layout.code, 2);
    expect_told({layout.errors});
    EXPECT_EQ(run_pendular("import " PENDULAR_SOURCE_DIR "/examples/wet --layout trios").code, 2);
}

TEST(ImportFile, WritesATidyTableWithRowsOfNamesAndUnits) {
    const TemporaryFolder folder;
    const auto table = folder.path() / "tidy.csv";
    ASSERT_EQ(run_pendular("import " + look_alikes + "trios.csv --tidy " + table.string()).code, 0);
    expect_told({content_of(table)});
    EXPECT_EQ(run_pendular("import " + table.string() + " --tidy " + table.string()).code, 2);
    // Another tidy table is replaced, a recording is not; then no study is begun either.
    EXPECT_EQ(run_pendular("import " + look_alikes + "trios.csv --tidy " + table.string()).code, 0);
    const auto recording = folder.write("recording.csv", "Time [s],Torque [mN m]\n1,2\n");
    const auto study = folder.path() / "study";
    const Outcome refused = run_pendular("import " + look_alikes + "powder_cell_all.txt --tidy " +
                                         recording.string() + " --study " + study.string());
    EXPECT_EQ(refused.code, 2);
    EXPECT_EQ(content_of(recording), "Time [s],Torque [mN m]\n1,2\n");
    EXPECT_FALSE(std::filesystem::exists(study));
}

TEST(ImportFile, BeginsNoStudyWithoutAnythingToRead) {
    const TemporaryFolder folder;
    const auto study = folder.path() / "study";
    const Outcome run =
        run_pendular("import " + look_alikes + "rheowin.csv --study " + study.string());
    EXPECT_EQ(run.code, 2);
    expect_told({run.errors});
    EXPECT_FALSE(std::filesystem::exists(study));
}

/// The look-alike of a yield-locus test has three points of failure and three states of preshear,
/// which are equal in all digits and therefore count once.
TEST(ImportFile, BeginsAStudyThatIsReadAtOnce) {
    const TemporaryFolder folder;
    const std::string study = (folder.path() / "begun").string();
    const std::string command = "import " + look_alikes + "powder_cell_all.txt --study " + study;
    const Outcome begun = run_pendular(command);
    ASSERT_EQ(begun.code, 0);
    expect_told({begun.output, content_of(study + "/study.toml")});
    const Outcome read = run_pendular("import " + study);
    EXPECT_EQ(read.code, 0) << read.errors;
    expect_told({read.output});
    const Outcome again = run_pendular(command);
    EXPECT_EQ(again.code, 2);
    expect_told({again.errors});
}

TEST(ImportFile, BeginsAStudyOfSteadyShearWithItsRecording) {
    const TemporaryFolder folder;
    std::string rows = pendular::recording_header;
    for (int i = 0; i < 400; ++i)
        rows +=
            std::to_string(0.1 * i) + "," + std::to_string(30 + (i * i) % 7 * 0.01) + ",5,14.2,1\n";
    const auto file = folder.write("wet [1] 500um.csv", rows);
    const std::string study = (folder.path() / "begun").string();
    ASSERT_EQ(run_pendular("import '" + file.string() + "' --study " + study).code, 0);
    expect_told({content_of(study + "/study.toml")});
    EXPECT_EQ(run_pendular("import " + study).code, 0);
}

TEST(ImportFile, ReadsEverySheetOfAWorkbookAndBeginsAStudyWithThem) {
    const TemporaryFolder folder;
    std::string low = "Zeit;Drehmoment;Normalkraft;Spalt;Drehzahl\ns;mN m;N;mm;1/min\n", high = low;
    for (int i = 0; i < 60; ++i) {
        low += fmt::format("{};20.{};5;6.2;5\n", i, 1 + i % 3);
        high += fmt::format("{};40.{};10;6.2;5\n", i, 1 + i % 3);
    }
    const std::string points =
        "sigma pre [Pa];tau pre [Pa];Normal stress [Pa];Shear stress [Pa]\n"
        "3000;1550;500;310\n3000;1550;1000;555\n3000;1550;1500;812\n3000;1550;2000;1050\n";
    const auto book = folder.path() / "book.xlsx", study = folder.path() / "study";
    const std::string command = fmt::format(
        "python3 {}/tests/data/make_workbook.py {} Cover={} '3 kPa'={} '6 kPa'={} Points={}",
        PENDULAR_SOURCE_DIR, book.string(), folder.write("c.csv", "Powder;glass\n").string(),
        folder.write("l.csv", low).string(), folder.write("h.csv", high).string(),
        folder.write("p.csv", points).string());
    ASSERT_EQ(std::system(command.c_str()), 0);
    const Outcome run = run_pendular("import " + book.string() + " --study " + study.string());
    EXPECT_EQ(run.code, 0) << run.errors;
    expect_told({run.output, content_of(study / "study.toml")});
    const Outcome read = run_pendular("import " + study.string() + " --json -");
    EXPECT_EQ(read.code, 0) << read.errors;
    const auto json =
        nlohmann::json::parse(run_pendular("import " + book.string() + " --json -").output);
    EXPECT_EQ(json["further_sheets"].size(), 2u);
    EXPECT_EQ(json["further_sheets"][1]["yield_loci"][0]["points"].size(), 4u);
}

/// Workbook with the tables of steady shear in "3 kPa" and of a wrong cell in "6 kPa".
TEST(ImportFile, RefusesAChosenSheetThatCannotBeRead) {
    const TemporaryFolder folder;
    std::string good = "Zeit;Drehmoment;Normalkraft;Spalt;Drehzahl\ns;mN m;N;mm;1/min\n",
                bad = good;
    for (int i = 0; i < 60; ++i) {
        good += fmt::format("{};20.{};5;6.2;5\n", i, 1 + i % 3);
        bad += i == 30 ? "30;#DIV/0!;5;6.2;5\n" : fmt::format("{};20.1;5;6.2;5\n", i);
    }
    const auto book = folder.path() / "book.xlsx", study = folder.path() / "study";
    const std::string command = fmt::format(
        "python3 {}/tests/data/make_workbook.py {} '3 kPa'={} '6 kPa'={}", PENDULAR_SOURCE_DIR,
        book.string(), folder.write("g.csv", good).string(), folder.write("b.csv", bad).string());
    ASSERT_EQ(std::system(command.c_str()), 0);
    EXPECT_EQ(run_pendular("import " + book.string() + " --sheet '* kPa'").code, 2);
    // Without a choice, the other sheet is read, and the study names it.
    const Outcome run = run_pendular("import " + book.string() + " --study " + study.string());
    ASSERT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(content_of(study / "study.toml"), HasSubstr("sheet = \"3 kPa\""));
    EXPECT_NE(run_pendular("import " + study.string()).code, 2);  // the cell is guessed
}

/// The sheet of points states the radii, and that of steady shear needs the mass of the beads.
TEST(ImportFile, BeginsAStudyWithTheStatedRadiiAndTheMassOfTheBeads) {
    const TemporaryFolder folder;
    std::string steady = "Zeit;Drehmoment;Normalkraft;Spalt;Drehzahl\ns;mN m;N;mm;1/min\n";
    for (int i = 0; i < 60; ++i)
        steady += fmt::format("{};20.{};5;6.2;5\n", i, 1 + i % 3);
    const std::string points =
        "Inner radius: 21 mm\nOuter radius: 45 mm\nNormal stress [Pa];Shear stress [Pa]\n"
        "500;310\n1000;555\n1500;812\n2000;1050\n";
    const auto book = folder.path() / "book.xlsx", study = folder.path() / "study";
    const auto first = folder.write("s.csv", steady), second = folder.write("p.csv", points);
    for (const std::string order : {"A={0} B={1}", "A={1} B={0}"}) {
        const std::string sheets =
            fmt::format(fmt::runtime(order), first.string(), second.string());
        const std::string command = fmt::format("python3 {}/tests/data/make_workbook.py {} {}",
                                                PENDULAR_SOURCE_DIR, book.string(), sheets);
        ASSERT_EQ(std::system(command.c_str()), 0);
        std::filesystem::remove_all(study);
        const Outcome run = run_pendular("import " + book.string() + " --study " + study.string());
        ASSERT_EQ(run.code, 0) << run.errors;
        const std::string toml = content_of(study / "study.toml");
        EXPECT_THAT(toml, HasSubstr("inner_radius = \"21 mm\"")) << order;
        EXPECT_THAT(toml, HasSubstr("bead_mass = ")) << order;
    }
}

TEST(ImportFile, NamesTheTableOfReadingsThatAFileIs) {
    const TemporaryFolder folder;
    const auto file =
        folder.write("steady.csv",
                     "Normal stress [Pa],Shear stress [Pa],Solid fraction,Shear rate [1/s]\n"
                     "500,210,0.6,0.1\n1000,405,0.6,0.1\n2000,810,0.59,0.1\n4000,1600,0.59,0.1\n");
    const Outcome run = run_pendular("import " + file.string());
    EXPECT_EQ(run.code, 0) << run.errors;
    expect_told({run.output});
}

TEST(ImportFile, TakesColumnsAsMessagesStateThem) {
    const std::string file = look_alikes + "headerless.csv";
    const auto refused = run_pendular("import " + file);
    EXPECT_EQ(refused.code, 2);
    const std::size_t list = refused.errors.find("columns = [");
    ASSERT_NE(list, std::string::npos) << refused.errors;
    const std::string columns = refused.errors.substr(list, refused.errors.rfind(']') - list + 1);
    expect_told({run_pendular("import " + file + " --columns '" + columns + "'").output});
}

TEST(ImportFile, QuotesThePathOfTheNextCommand) {
    const TemporaryFolder folder;
    const auto file = folder.path() / "two words.txt";
    std::filesystem::copy_file(look_alikes + "powder_cell_all.txt", file);
    expect_told({run_pendular("import '" + file.string() + "'").output});
}

/// Two tests, of which the preshear of the second still rises by a tenth in its last rows.
TEST(ImportFile, TakesPreshearsWithAPlateauForSteadyShear) {
    const TemporaryFolder folder;
    std::string rows = "Point No.,Normal Stress,Shear Stress\n,[Pa],[Pa]\n";
    for (const auto& [normal, rise] :
         {std::pair{3000.0, 0.0}, {1000.0, 0.0}, {6000.0, 0.1}, {2000.0, 0.0}})
        for (int i = 1; i <= 100; ++i)
            rows += std::to_string(i) + "," + std::to_string(normal) + "," +
                    std::to_string(0.3 * normal * (i < 80 ? 1 : 1 + rise * (i - 80) / 20)) + "\n";
    const auto file = folder.write("run.csv", rows);
    const std::string study = (folder.path() / "begun").string();
    ASSERT_EQ(run_pendular("import " + file.string() + " --study " + study).code, 0);
    expect_told({content_of(study + "/steady.csv")});
}

/// Bulk densities of 1450 and 1480 kg/m^3 of glass of 2500 kg/m^3.
TEST(ImportFile, BeginsAStudyFromAReportOnYieldLoci) {
    const TemporaryFolder folder;
    const std::string study = (folder.path() / "begun").string();
    const Outcome begun =
        run_pendular("import " + look_alikes + "yield_locus_report.txt --study " + study);
    ASSERT_EQ(begun.code, 0) << begun.errors;
    expect_told({begun.output, content_of(study + "/study.toml")});
    const auto json = json_of("import " + study);
    std::vector<double> fractions;
    for (const auto& reading : json.at("readings"))
        if (!reading.at("failure").get<bool>())
            fractions.push_back(reading.at("solid_fraction").at("value").get<double>());
    EXPECT_THAT(fractions, testing::ElementsAre(testing::DoubleNear(0.58, 1e-6),
                                                testing::DoubleNear(0.592, 1e-6)));
    EXPECT_EQ(json.at("readings").size(), 7u);
}

TEST(ImportFile, ComparesTheHeaderWithTheStudyBesideTheFile) {
    const TemporaryFolder folder;
    std::string rows =
        "# Inner radius: 20 mm\n# Outer radius: 45 mm\n" + pendular::recording_header;
    for (int i = 0; i < 400; ++i)
        rows +=
            std::to_string(0.1 * i) + "," + std::to_string(30 + (i * i) % 7 * 0.01) + ",5,2.1,1\n";
    const auto file = folder.write("run.csv", rows);
    const std::string study = (folder.path() / "begun").string();
    const Outcome alone = run_pendular("import " + file.string() + " --study " + study);
    EXPECT_EQ(alone.code, 0) << alone.errors;
    const std::string begun = content_of(study + "/study.toml");
    expect_told({alone.output, begun});
    std::string other = begun;
    other.replace(other.find("20 mm"), 5, "21 mm");
    folder.write("begun/study.toml", other);
    for (const std::string& named : {study, study + "/run.csv"}) {
        const Outcome run = run_pendular("import " + named);
        // With the guessed mass of beads, the study keeps no reading.
        EXPECT_EQ(run.code, named == study ? 3 : 0) << run.errors;
        expect_told({run.output});
    }
}

/// Two steps of 100 rows at 1 rad/s, with the normal force counted as the factor says.
std::string two_steps(double factor) {
    std::string text =
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],"
        "Interval [1]\n";
    for (int row = 0; row < 200; ++row) {
        const double force = row < 100 ? 5 : 10, noise = 0.01 * ((7 * row) % 11 - 5);
        text += fmt::format("{},{},{},{},1,{}\n", row, 4 * force * (1 + noise),
                            factor * force * (1 + 0.1 * noise), 6.2 * (1 + 0.01 * noise),
                            row < 100 ? 1 : 2);
    }
    return text;
}

TEST(Import, SaysTheReasonThatAllStepsShareAndEndsWithThree) {
    const TemporaryFolder folder;
    folder.write("study.toml",
                 "[grains]\ndiameter = \"500 um\"\ndensity = \"2500 kg/m^3\"\n[cell]\n"
                 "inner_radius = \"21 mm\"\nouter_radius = \"45 mm\"\nbead_mass = \"46 g\"\n"
                 "[[recording]]\nfile = \"dry.csv\"\n");
    const auto file = folder.write("dry.csv", two_steps(-1));
    const std::string study = folder.path().string();
    const Outcome import = run_pendular("import " + study);
    EXPECT_EQ(import.code, 3);
    std::vector<std::string> told = {import.output};
    for (const char* const command : {"calibrate", "compare", "diagnose"}) {
        const Outcome run = run_pendular(fmt::format("{} {}", command, study));
        EXPECT_EQ(run.code, 2) << command;
        told.push_back(run.errors);
    }
    const Outcome of_file = run_pendular("import " + file.string());
    EXPECT_EQ(of_file.code, 2);
    told.push_back(of_file.output);
    expect_told(told);
    folder.write("dry.csv", two_steps(1));
    EXPECT_EQ(run_pendular("import " + study).code, 0);
}

}  // namespace app_import_file_test
