// Recordings on a page: against the time where the rows have one.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "reports/page/page_data.h"
#include "tests/support/data_support.h"

namespace pendular::reports_page_recordings_test {

/// Recording of `intervals` intervals of `rows` rows at 300 Pa, one each 2 s; the time begins at 0
/// in each interval if `again`.
FileView recording(const TemporaryFolder& folder, int intervals, int rows, bool again) {
    std::string text = "Time [s],Interval,Normal Stress [Pa],Shear Stress [Pa]\n";
    for (int i = 0; i < intervals; ++i)
        for (int k = 0; k < rows; ++k)
            text += std::to_string(2 * (again ? k : k + i * rows)) + "," + std::to_string(i + 1) +
                    ",1000," + std::to_string(300 + k % 7) + "\n";
    return view_of_file(folder.write("recording.csv", text));
}

TEST(PageRecordings, StandAgainstTheTime) {
    const TemporaryFolder folder;
    const PageRecording shown = page_recording(recording(folder, 2, 50, false), {}, {}, 400);
    const auto json = recordings_json({shown}, {})[0];
    EXPECT_EQ(json["x_label"], "time [s]");
    EXPECT_DOUBLE_EQ(json["from"], 0);
    EXPECT_DOUBLE_EQ(json["span"], 198);  // 100 rows, 2 s apart
}

TEST(PageRecordings, PutIntervalsThatCountFromZeroOneAfterTheOther) {
    const TemporaryFolder folder;
    const PageRecording shown = page_recording(recording(folder, 3, 50, true), {}, {}, 400);
    EXPECT_TRUE(std::ranges::is_sorted(shown.time));
    EXPECT_DOUBLE_EQ(shown.time.back(), 3 * 98);  // each interval lasts from 0 to 98 s
}

TEST(PageRecordings, OfLongTestsCountMinutes) {
    const TemporaryFolder folder;
    const auto json =
        recordings_json({page_recording(recording(folder, 1, 400, false), {}, {}, 400)}, {})[0];
    EXPECT_EQ(json["x_label"], "time [min]");
    EXPECT_NEAR(json["span"], 798 / 60.0, 1e-5);
}

TEST(PageRecordings, WithoutATimeStandAgainstTheRow) {
    const TemporaryFolder folder;
    std::string text = "Point No.,Normal Stress,Shear Stress\n,[Pa],[Pa]\n";
    for (int i = 1; i <= 100; ++i)
        text += std::to_string(i) + ",1000,300\n";
    const PageRecording shown =
        page_recording(view_of_file(folder.write("rows.csv", text)), {}, {}, 400);
    const auto json = recordings_json({shown}, {})[0];
    EXPECT_EQ(json["x_label"], "row of the recording");
    EXPECT_DOUBLE_EQ(json["from"], 1);
    EXPECT_DOUBLE_EQ(json["span"], 99);
}

}  // namespace pendular::reports_page_recordings_test
