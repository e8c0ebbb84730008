// `pendular report` on studies that lack something says so plainly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>

#include "tests/support/app_support.h"

namespace pendular::app_report_test {

using testing::HasSubstr;
using testing::Not;

namespace fs = std::filesystem;

class ReportTest : public testing::Test {
  protected:
    TemporaryFolder folder;
    std::string study = copied_example("dry-recordings", folder).string();

    Outcome report(const std::string& more = "") const {
        return run_pendular("report " + study + " --quiet --switches 0" + more);
    }
    std::string page() const { return content_of(fs::path(study) / "out/report.html"); }
};

TEST_F(ReportTest, OfAStudyThatWasNeverCalibratedSaysSo) {
    EXPECT_EQ(report().code, 0);
    const std::string html = page();
    const std::size_t header = html.find("<header>");
    expect_told({html.substr(header, html.find("</header>") - header)});
}

TEST_F(ReportTest, OfAStudyWithoutWetReadingsShowsDryReadingsOnly) {
    EXPECT_EQ(report().code, 0);
    EXPECT_THAT(page(), HasSubstr("Dry readings"));
    EXPECT_THAT(page(), Not(HasSubstr("Wet readings")));
}

TEST_F(ReportTest, OfASingleReadingSaysWhatIsNeeded) {
    folder.write("one.csv",
                 "normal_stress [Pa],stress_ratio [1],solid_fraction [1],inertial_number [1]\n"
                 "1000,0.28,0.61,0.01\n");
    folder.write("study.toml",
                 grains_table + "[[readings]]\nfile = \"one.csv\"\nliquid_content = 0\n");
    study = folder.path().string();
    const Outcome outcome = report();
    EXPECT_EQ(outcome.code, 2);
    expect_told({outcome.errors});
    EXPECT_FALSE(fs::exists(folder.path() / "out/report.html"));
}

TEST_F(ReportTest, WritesATableAndAParagraphToPaste) {
    const Outcome outcome = report();
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    const fs::path out = fs::path(study) / "out";
    EXPECT_THAT(
        content_of(out / "results.csv"),
        testing::ContainsRegex("quantity,value,standard error,unit,remark\n"
                               "intergranular friction coefficient,0\\.[0-9]+,0\\.[0-9]+,1,\n"));
    const std::string latex = content_of(out / "results.tex");
    EXPECT_THAT(latex, HasSubstr("$\\pm$"));
    EXPECT_THAT(latex, Not(HasSubstr("+-")));
    const std::string methods = content_of(out / "methods.txt");
    expect_told(
        {outcome.output,
         std::regex_replace(methods, std::regex("[0-9]+\\.[0-9]+\\.[0-9]+|[0-9a-f]{16}"), "N")});
}

TEST_F(ReportTest, NeedsNoGnuplot) {
    const Outcome outcome = [&] {
        const std::string path = std::getenv("PATH");
        setenv("PATH", folder.path().c_str(), 1);
        const Outcome result = report();
        setenv("PATH", path.c_str(), 1);
        return result;
    }();
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(page(), HasSubstr("Dry readings"));
}

TEST_F(ReportTest, SaysThatTheFolderCannotBeWritten) {
    folder.write("a-file", "");
    const std::string file = (folder.path() / "a-file").string();
    expect_refused({"report " + study + " --out " + file + "/results"});
    EXPECT_FALSE(fs::exists(fs::path(study) / "out"));
}

}  // namespace pendular::app_report_test
