// What is said of a recording whose gap is shown too large in a study that lacks an effect as well.
#include "reports/odd_file_report.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/changed_example.h"
#include "workflow/session.h"

namespace pendular::odd_file_report_test {

namespace fs = std::filesystem;

/// Text of a recording with a larger gap [mm].
std::string shifted(const std::string& recording, double shift) {
    return with_cells(recording, [shift](std::vector<std::string>& cells) {
        cells.at(gap_column) = fmt::format("{:.6g}", std::stod(cells.at(gap_column)) + shift);
    });
}

StudyDiagnosis diagnosis_of(const fs::path& study) {
    return Session(study, {.fidelity = fidelity_named("quick")}).diagnose();
}

// Of four files, two of a kind, a gap that is wrong by 0.6 % cannot be told from fillings that
// differ; one that is wrong by 2.7 % is worth a look.
TEST(OddFileReport, NamesTheRecordingWithAShiftedGapBesideAMissingEffect) {
    const TemporaryFolder folder;
    const fs::path study = copy_of_example(folder);
    const std::string recording = content_of(study / "wet_0.03_1.csv");
    EXPECT_EQ(odd_file_line(diagnosis_of(study)), "");
    folder.write("study/wet_0.03_1.csv", shifted(recording, 0.12));
    const StudyDiagnosis small = diagnosis_of(study);
    EXPECT_EQ(odd_file_line(small), "");
    expect_told({files_line(small)});
    folder.write("study/wet_0.03_1.csv", shifted(recording, 0.5));
    const StudyDiagnosis large = diagnosis_of(study);
    EXPECT_EQ(odd_file_line(large), files_line(large));
    expect_told({odd_file_line(large)});
}

TEST(OddFileReport, SaysHowSurelyAFileIsOdd) {
    const OddFile sure{.file = "run/wet_3.csv",
                       .observable = 1,
                       .deviation = 0.012,
                       .others = -0.0004,
                       .files = 8,
                       .p = 0.001,
                       .height = 0.0187};
    OddFile stress = sure;
    stress.observable = 0, stress.p = 0.2, stress.alone = true;
    expect_told(
        {odd_file_text(sure, "the model"), odd_file_text(stress, "the model with wall-friction")});
}

}  // namespace pendular::odd_file_report_test
