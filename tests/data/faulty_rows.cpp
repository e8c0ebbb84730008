// Rows whose fault must be seen: left out in silence, they would change a mean.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "data/files/formats/layouts.h"
#include "data/recordings/file_view.h"
#include "data/recordings/recording.h"
#include "data/remarks/remark.h"
#include "tests/support/golden.h"

namespace pendular::data_faulty_rows_test {

using testing::SizeIs;

constexpr int rows = 40;

/// Recording whose torque stands first.
/// @param torque text of a row's torque [mN m]
template <typename Text>
std::string recording_with(const Text& torque) {
    std::string text =
        "Torque [mN m],Time [s],Normal force [N],Gap [mm],Angular velocity [rad/s]\n";
    for (int i = 0; i < rows; ++i)
        text += fmt::format("{},{}.5,5.0,6.2,0.5\n", torque(i), i);
    return text;
}

TEST(DashBeforeANumber, IsAMinus) {
    const TemporaryFolder folder;
    const auto torque = [](int i) { return fmt::format("{}2.{}5", i % 4 ? "" : "\u2013", i % 5); };
    const Recording recording = read_recording(folder.write("t.csv", recording_with(torque)));
    ASSERT_THAT(recording.torque, SizeIs(rows));
    EXPECT_LT(recording.torque[4], 0);
    EXPECT_GT(recording.torque[5], 0);
}

/// An instrument writes OL for a torque beyond its range: the mean without those rows is too small.
TEST(WordForOverload, IsRefusedWithItsLine) {
    const TemporaryFolder folder;
    const auto torque = [](int i) { return i % 4 ? fmt::format("2.{}5", i % 5) : "OL"; };
    const auto file = folder.write("t.csv", recording_with(torque));
    expect_told({input_error([&] { read_recording(file); })});
}

/// Means below a table are no rows of it, however many numbers they have.
TEST(LineOfMeans, BelowATableIsLeftOut) {
    const TemporaryFolder folder;
    const auto torque = [](int i) { return fmt::format("2.{}5", i % 5); };
    for (const std::string word : {"Mean", "Mittelwert", "Écart type", "StdDev"}) {
        const auto file =
            folder.write("t.csv", recording_with(torque) + word + ",19.5,5.0,6.2,0.5\n");
        EXPECT_EQ(read_recording(file).size(), rows) << word;
    }
}

/// Each load has a sample of its own: no line goes through points at one load.
TEST(SampleOfEachLoad, MakesOneLocusOfAll) {
    const TemporaryFolder folder;
    std::string text = "Sample,Normal stress [kPa],Shear stress [kPa]\n";
    for (int load = 7; load >= 4; --load)
        for (int repeat = 0; repeat < 2; ++repeat)
            text += fmt::format("s{},{},{:.2f}\n", load, load, 0.5 * load + 0.5 + 0.01 * repeat);
    EXPECT_THAT(view_of_file(folder.write("t.csv", text), {}).loci, SizeIs(1));
}

/// Each sample has points at several loads, written with decimal commas.
TEST(SampleOfSeveralLoads, MakesALocusOfEach) {
    const TemporaryFolder folder;
    std::string text = "Sample;Normal stress [kPa];Shear stress [kPa]\n";
    for (int load = 7; load >= 4; --load)
        for (int sample = 1; sample <= 2; ++sample)
            text += fmt::format("s{};{},25;{},{}5\n", sample, load, load / 2, load);
    EXPECT_THAT(view_of_file(folder.write("t.csv", text), {}).loci, SizeIs(2));
}

/// A workbook merges "No." over the rows of names and of units.
TEST(NameMergedOverTheUnits, LeavesThemUnits) {
    const TemporaryFolder folder;
    std::string text =
        "No.,Time,Torque,Normal force,Gap,Angular velocity\n"
        "No.,[s],[mN m],[N],[mm],[rad/s]\n";
    for (int i = 0; i < rows; ++i)
        text += fmt::format("{},{}.5,2{}.25,5,6.2,0.5\n", i + 1, i, i % 5);
    const Recording recording = read_recording(folder.write("t.csv", text));
    ASSERT_THAT(recording.torque, SizeIs(rows));
    EXPECT_NEAR(recording.torque[1], 21.25e-3, 1e-12);
}

}  // namespace pendular::data_faulty_rows_test
