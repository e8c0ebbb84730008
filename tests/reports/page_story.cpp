// What the first picture of the page shows beside the models of the study, and how the page writes
// numbers.
#include "reports/page/page_story.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/next_steps.h"
#include "reports/page/page_data.h"
#include "tests/support/changed_example.h"
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

TEST(PageStory, ShowsTheReadingsWithTheErrorOfASuspectMeasurementCorrected) {
    const TemporaryFolder folder;
    const fs::path study = copy_with_its_effect(folder);
    const Session whole(study, {.fidelity = fidelity_named("quick")});
    const StudyDiagnosis complete = whole.diagnose();
    const SwitchedModels switched =
        switched_models(whole.resolved(), complete, whole.options(), {.most = 1});
    EXPECT_FALSE(page_story({}, complete, switched).corrected);
    const auto third_too_high = [](std::vector<std::string>& cells) {
        if (cells.at(interval_column) == "3")
            cells[torque_column] = fmt::format("{:.6g}", 1.08 * std::stod(cells[torque_column]));
    };
    for (const char* const file : {"study/dry_1.csv", "study/dry_2.csv"})
        folder.write(file, with_cells(content_of(folder.path() / file), third_too_high));
    const StudyDiagnosis diagnosis =
        Session(study, {.fidelity = fidelity_named("quick")}).diagnose();
    const auto corrected = page_story({}, diagnosis, switched).corrected;
    ASSERT_TRUE(corrected);
    ASSERT_EQ(corrected->deviations[0].size(), diagnosis.readings.size());
    expect_told(
        {corrected->of, texts_of(next_steps(diagnosis, {}, whole.resolved(), "beads")).front()});
    EXPECT_LT(corrected->rms[0], 1.2);  // 1.9 % with the error, 0.8 % without
}

}  // namespace pendular::page_story_test
