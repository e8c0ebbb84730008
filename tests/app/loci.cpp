// Yield loci and flow functions from the command line, and what the program reads of its own files.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "tests/support/app_support.h"

namespace app_loci_test {

using pendular::TemporaryFolder;
using testing::StartsWith;

/// Points of failure after a preshear of normal stress `pre` [Pa], about the line 0.1 pre + 0.45 s.
std::string points(double pre, const std::string& before =
                                   "Vorscherspannung [Pa];tau pre [Pa];"
                                   "Normalspannung [Pa];"
                                   "Schubspannung [Pa]\n") {
    std::string text = before;
    for (const int k : {1, 2, 3, 4, 5}) {
        const double s = 0.15 * k * pre;
        text += fmt::format("{};{:.1f};{:.1f};{:.1f}\n", pre, 0.56 * pre + k % 3, s,
                            0.1 * pre + 0.45 * s + (k % 2 == 0 ? 3 : -3));
    }
    return text;
}

std::string of_sheets(const TemporaryFolder& folder, const std::string& points) {
    std::string low = "Zeit [s];Drehmoment [mNm];Normalkraft [N];Spalt [mm];Drehzahl [U/min]\n",
                high = low;
    for (int i = 0; i < 200; ++i) {
        low += fmt::format("{};{:.2f};6.2;14.{:02};9.5\n", i, 30 + i * i % 7 * 0.1, i * i % 5);
        high += fmt::format("{};{:.2f};12.4;14.{:02};9.5\n", i, 60 + i * i % 7 * 0.2, i * i % 5);
    }
    const auto book = folder.path() / "versuch.xlsx";
    const std::string command = fmt::format(
        "python3 {}/tests/data/make_workbook.py {} '2 kPa'={} '4 kPa'={} Bruchpunkte={}",
        PENDULAR_SOURCE_DIR, book.string(), folder.write("l.csv", low).string(),
        folder.write("h.csv", high).string(), folder.write("p.csv", points).string());
    EXPECT_EQ(std::system(command.c_str()), 0);
    return book.string();
}

/// Commands of docs/how-to/yield-locus.md on a German workbook, but for the calibration.
TEST(YieldLoci, OfAGermanWorkbookBeginAStudy) {
    const TemporaryFolder folder;
    const std::string book = of_sheets(folder, points(4000, points(2000)));
    const std::string study = (folder.path() / "versuch").string(),
                      loci = (folder.path() / "loci.csv").string();
    const auto figures = folder.path() / "figures";
    const Outcome run = run_pendular("import " + book + " --study " + study + " --figures " +
                                     figures.string() + " --loci " + loci);
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_EQ(std::ranges::count(content_of(figures / "flow_function.csv"), '\n'), 3);
    expect_told({run.output, content_of(loci), content_of(study + "/study.toml")});
    const Outcome read = run_pendular("import " + study);
    EXPECT_EQ(read.code, 0) << read.errors << read.output;
    expect_told({read.output});
}

TEST(YieldLoci, OfSeveralFilesGiveAFlowFunction) {
    const TemporaryFolder folder;
    const std::string files = folder.write("2kPa.csv", points(2000)).string() + " " +
                              folder.write("4kPa.csv", points(4000)).string();
    const auto figures = folder.path() / "figures", study = folder.path() / "study";
    const Outcome run = run_pendular("import " + files + " --figures " + figures.string() +
                                     " --prorate --study " + study.string());
    EXPECT_EQ(run.code, 0) << run.errors;
    expect_told({run.output, content_of(figures / "flow_function.csv")});
    EXPECT_TRUE(std::filesystem::exists(study / "failure_2.csv"));
    EXPECT_EQ(run_pendular("import " + study.string()).code, 0);
    EXPECT_EQ(run_pendular("import " + files + " " + study.string()).code, 2);
}

TEST(YieldLoci, AlongAWallAreADirectMeasurement) {
    const TemporaryFolder folder;
    const auto wall =
        folder.write("wall.csv",
                     "Wall normal stress [Pa],Wall shear stress [Pa]\n500,183\n1000,362\n2000,728\n"
                     "4000,1451\n");
    const Outcome run = run_pendular("import " + wall.string());
    EXPECT_EQ(run.code, 0) << run.errors;
    expect_told({run.output});
    // The lines, pasted below a study, are read.
    std::string lines = run.output.substr(run.output.find("[[direct]]"));
    lines = lines.substr(0, lines.find('\n', lines.find("error =")));
    folder.write("points.csv",
                 "normal_stress [Pa],shear_stress [Pa],solid_fraction [1],inertial_number [1]\n"
                 "1000,300,0.6,0.01\n2000,600,0.6,0.01\n");
    folder.write("study.toml",
                 "[grains]\ndiameter = \"500 um\"\ndensity = \"2500 kg/m^3\"\n[cell]\n"
                 "inner_radius = \"20 mm\"\nouter_radius = \"40 mm\"\nbead_mass = \"60 g\"\n"
                 "[[readings]]\nfile = "
                 "\"points.csv\"\n" +
                     lines + "\n");
    const Outcome study = run_pendular("import " + folder.path().string());
    EXPECT_EQ(study.code, 0) << study.errors;
}

TEST(ImportFile, OfWhichNothingIsUsedSaysSoFirst) {
    const TemporaryFolder folder;
    std::string sweep =
        "Time [s],Storage Modulus [Pa],Loss Modulus [Pa],Shear stress [Pa],"
        "Normal stress [Pa]\n";
    for (int i = 0; i < 30; ++i)
        sweep += fmt::format("{},1200,300,{},100\n", i, 50 + i);
    const Outcome other = run_pendular("import " + folder.write("sweep.csv", sweep).string());
    EXPECT_EQ(other.code, 2);
    EXPECT_THAT(other.output, StartsWith("Nothing of sweep.csv is used: oscillation"));
    std::string no_gap = "Time [s],Torque [mN m],Normal force [N],Speed [rpm]\n";
    for (int i = 0; i < 30; ++i)
        no_gap += fmt::format("{},20,5,5\n", i);
    const Outcome missing = run_pendular("import " + folder.write("no_gap.csv", no_gap).string());
    EXPECT_EQ(missing.code, 2);
    EXPECT_THAT(missing.output, StartsWith("Nothing of no_gap.csv is used: it has no gap"));
}

/// Every table that the program writes, given to `import` again.
TEST(OwnFiles, AreReadOrCalledWhatTheyAre) {
    const TemporaryFolder folder;
    const std::string book = of_sheets(folder, points(3000));
    const std::string study = (folder.path() / "study").string(),
                      tidy = (folder.path() / "tidy.csv").string(),
                      loci = (folder.path() / "loci.csv").string(),
                      figures = (folder.path() / "figures").string();
    ASSERT_EQ(run_pendular("import " + book + " --study " + study + " --tidy " + tidy + " --loci " +
                           loci + " --figures " + figures)
                  .code,
              0);
    ASSERT_EQ(run_pendular("import " + study + " --figures " + figures).code, 0);
    std::vector<std::string> told;
    std::vector<std::filesystem::path> files = {tidy, loci, study + "/failure_3.csv",
                                                study + "/out/readings.csv",
                                                study + "/out/excluded.csv"};
    for (const auto& entry : std::filesystem::directory_iterator(figures))
        if (entry.path().extension() == ".csv") files.push_back(entry.path());
    std::sort(files.begin() + 5, files.end());
    for (const auto& file : files) {
        const Outcome run = run_pendular("import " + file.string());
        EXPECT_TRUE(run.code == 0 || run.code == 2) << file << run.errors;
        const std::string first = run.output.empty() ? run.errors : run.output;
        told.push_back(fmt::format("{} {}", run.code, first.substr(0, first.find('\n'))));
    }
    expect_told(told);
    // As a table of readings, readings.csv is read again to the same number of readings.
    const std::string readings = content_of(study + "/out/readings.csv");
    folder.write("again.csv", readings);
    folder.write("study.toml",
                 "[grains]\ndiameter = \"500 um\"\ndensity = \"2500 kg/m^3\"\n[cell]\n"
                 "inner_radius = \"10.5 mm\"\nouter_radius = \"21.5 mm\"\n[[readings]]\nfile = "
                 "\"again.csv\"\n");
    const Outcome again = run_pendular("import " + folder.path().string());
    EXPECT_EQ(again.code, 0) << again.errors;
    EXPECT_EQ(std::ranges::count(content_of(folder.path() / "out/readings.csv"), '\n'),
              std::ranges::count(readings, '\n'));
}

}  // namespace app_loci_test
