// What the first picture of the page shows beside the models of the study, and how the page writes
// numbers.
#include "reports/page/page_story.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "reports/next_steps.h"
#include "reports/page/page_data.h"
#include "tests/support/data_support.h"
#include "workflow/session.h"
#include "workflow/switched_models.h"

namespace pendular::page_story_test {

namespace fs = std::filesystem;

TEST(PageText, HasTheSignsOfPrint) {
    EXPECT_EQ(page_text("-110.7 +- 8.1 mN"), "−110.7 ± 8.1 mN");
    EXPECT_EQ(page_text("arm 252 +- 61 um (-3 uN m, -1 uPa)"), "arm 252 ± 61 µm (−3 µN m, −1 µPa)");
    for (const char* const same :
         {"2026-11-29", "1e-3", "torque-gain", "pendular add x --proposed 1", "10 users",
          "wet_-3.csv", "5 umbrellas"}) {
        EXPECT_EQ(page_text(same), same);
    }
}

/// Text of a recording of which the torque of one interval is too high by this factor.
std::string raised(const std::string& recording, const std::string& interval, double factor) {
    std::istringstream lines(recording);
    std::string line, text;
    std::getline(lines, text);
    text += '\n';
    while (std::getline(lines, line)) {
        std::vector<std::string> cells;
        std::istringstream row(line);
        for (std::string cell; std::getline(row, cell, ',');)
            cells.push_back(cell);
        if (cells.at(5) == interval)
            cells.at(1) = fmt::format("{:.6g}", factor * std::stod(cells[1]));
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return text;
}

TEST(PageStory, ShowsTheReadingsWithTheErrorOfASuspectMeasurementCorrected) {
    const TemporaryFolder folder;
    const fs::path study = folder.path() / "study";
    fs::copy(fs::path(PENDULAR_SOURCE_DIR) / "examples/hidden-effect", study);
    std::string text = content_of(study / "study.toml");
    const std::string none = "effects = []";
    ASSERT_NE(text.find(none), std::string::npos);
    folder.write("study/study.toml",
                 text.replace(text.find(none), none.size(), "effects = [\"wall-friction\"]"));
    const Session whole(study, {.fidelity = fidelity_named("quick")});
    const StudyDiagnosis complete = whole.diagnose();
    const SwitchedModels switched =
        switched_models(whole.resolved(), complete, whole.options(), {.most = 1});
    EXPECT_FALSE(page_story({}, complete, switched).corrected);
    for (const char* const file : {"study/dry_1.csv", "study/dry_2.csv"})
        folder.write(file, raised(content_of(folder.path() / file), "3", 1.08));
    const StudyDiagnosis diagnosis =
        Session(study, {.fidelity = fidelity_named("quick")}).diagnose();
    const auto corrected = page_story({}, diagnosis, switched).corrected;
    ASSERT_TRUE(corrected);
    EXPECT_THAT(corrected->of, testing::HasSubstr("1000 Pa"));
    ASSERT_EQ(corrected->deviations[0].size(), diagnosis.readings.size());
    EXPECT_THAT(texts_of(next_steps(diagnosis, {}, whole.resolved(), "beads")).front(),
                testing::HasSubstr("(dry_1.csv step 3, dry_2.csv step 3)"));
    EXPECT_LT(corrected->rms[0], 1.2);  // 1.9 % with the error, 0.8 % without
}

}  // namespace pendular::page_story_test
