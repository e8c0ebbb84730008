// `pendular reproduce`: published numbers beside simulated ones, and the figures of the paper.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tests/support/app_support.h"

namespace app_reproduce_test {

using nlohmann::json;
using pendular::TemporaryFolder;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// Figures of Badetti et al. (2018) that show simulations, by their labels.
const char* const figures[] = {"mustarphimu", "muphinertial", "philphis", "cexpnum",    "cphilphis",
                               "phiexpnum",   "coulombeff",   "zzcip",    "phisdiffmu", "appdiff",
                               "s12pred",     "cstarmu",      "cohcomp",  "cohgen",     "scaps",
                               "scapcd",      "fabric",       "scapdapp", "scapapp"};

TEST(ReferencePages, OfTheReproductionHoldsItsNumbersAndFigures) {
    const TemporaryFolder folder;
    const Outcome run = run_pendular(
        fmt::format("reproduce --all --out {0} --store {0}/none.sqlite --json {0}/r.json",
                    folder.path().string()));
    ASSERT_EQ(run.code, 0) << run.errors;
    for (const char* figure : figures) {
        for (const char* extension : {".svg", ".png", ".pdf", ".csv"}) {
            EXPECT_GT(fs::file_size(folder.path() / "figures" / (std::string(figure) + extension)),
                      200u)
                << figure << extension;
        }
    }
    // The scoreboard is printed, is on the page, which is that of the documentation, and is in the
    // JSON.
    const json rows = json::parse(content_of(folder.path() / "r.json"))["rows"];
    EXPECT_GE(rows.size(), 60u);
    const std::string page = content_of(folder.path() / "reproduction.md");
    const fs::path documented = PENDULAR_SOURCE_DIR "/docs/reproduction.md";
    pendular::expect_same_text(content_of(documented), page, documented, page);
    for (const json& row : rows) {
        const std::string what = row["what"];
        EXPECT_THAT(run.output, HasSubstr(what));
        EXPECT_THAT(page, HasSubstr("| " + what + " |"));
    }
}

TEST(Reproduce, PrintsWhatDisagreesAndSaysHowToSeeTheRest) {
    const TemporaryFolder folder;
    const Outcome run = run_pendular(
        fmt::format("reproduce --store {0}/none.sqlite --json {0}/r.json", folder.path().string()));
    ASSERT_EQ(run.code, 0) << run.errors;
    const json rows = json::parse(content_of(folder.path() / "r.json"))["rows"];
    for (const json& row : rows) {
        const std::string what = row["what"];
        if (row["agrees"]) {
            EXPECT_THAT(run.output, Not(HasSubstr(what + " "))) << what;
        } else {
            EXPECT_THAT(run.output, HasSubstr(what));
        }
    }
    expect_told({run.output.substr(run.output.rfind("Next: "))});
}

}  // namespace app_reproduce_test
