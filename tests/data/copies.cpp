#include "data/recordings/copies.h"

#include <fmt/format.h>

#include <cmath>

#include "data/recordings/measurements.h"
#include "tests/support/golden.h"

namespace pendular::data_copies_test {

using testing::IsEmpty;

/// Rows of a recording of 16 strains at 5 N with 1 % of noise in the torque.
struct Row {
    double time, torque, gap;
};
std::vector<Row> measured(unsigned seed, std::size_t rows = 200) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Row> result;
    for (std::size_t i = 0; i < rows; ++i)
        result.push_back({0.1 * static_cast<double>(i), 30 * (1 + 0.01 * normal(random)),
                          6.3 * (1 + 0.001 * normal(random))});
    return result;
}

/// As a file; the formats are of time, torque and gap.
std::string table(const std::vector<Row>& rows, const std::string& row = "{:.1f},{:.4f},5,{:.5f}") {
    std::string text = recording_header;
    for (const Row& each : rows)
        text += fmt::format(fmt::runtime(row + ",0.1\n"), each.time, each.torque, each.gap);
    return text;
}

const std::string study_text =
    grains_table + cell_table("20 g") + "[[recording]]\nfile = \"*_dry.csv\"\nliquid_content = 0\n";

class Copies : public testing::Test {
  protected:
    Copies() {
        folder_.write("study.toml", study_text);
        folder_.write("1_dry.csv", table(measured(1)));
    }
    Measurements read() { return read_measurements(read_study(folder_.path())); }
    /// Expects that only the first file makes a reading and that the second is named.
    void expect_one() {
        const Measurements all = read();
        ASSERT_EQ(all.readings.size(), 1u);
        EXPECT_EQ(all.readings[0].replicates, 1);
        EXPECT_THAT(all.readings[0].origin.file, testing::EndsWith("1_dry.csv"));
        expect_told(told_of(all));
    }
    TemporaryFolder folder_;
};

TEST_F(Copies, OfTheSameBytesCountOnce) {
    folder_.write("2_dry.csv", table(measured(1)));
    expect_one();
}

TEST_F(Copies, ThatAreLinksCountOnce) {
    for (const char* name : {"2_dry.csv", "3_dry.csv", "4_dry.csv", "5_dry.csv", "6_dry.csv"})
        std::filesystem::create_symlink(folder_.path() / "1_dry.csv", folder_.path() / name);
    EXPECT_EQ(read().readings.size(), 1u);
}

TEST_F(Copies, WrittenInOtherDigitsCountOnce) {
    folder_.write("2_dry.csv", table(measured(1), "{:.3e},{:.3e},5.0,{:.4g}"));
    expect_one();
}

TEST_F(Copies, InOtherUnitsCountOnce) {
    auto rows = measured(1);
    for (Row& row : rows)
        row = {row.time, row.torque / 1000, 1000 * row.gap};
    std::string text = table(rows, "{:.2f},{:.7f},5,{:.2f}");
    text.replace(0, text.find('\n'),
                 "Time [s],Torque [N m],Normal force [N],Gap [um],Angular velocity [rad/s]");
    folder_.write("2_dry.csv", text);
    expect_one();
}

TEST_F(Copies, ThatAreCutThinnedOutOrShiftedInTimeCountOnce) {
    const auto all = measured(1);
    folder_.write("2_dry.csv", table({all.begin() + 40, all.begin() + 140}));
    expect_one();
    std::vector<Row> thin, shifted = all;
    for (std::size_t i = 0; i < all.size(); i += 3)
        thin.push_back(all[i]);
    folder_.write("2_dry.csv", table(thin));
    expect_one();
    for (Row& row : shifted)
        row.time += 123.4;
    folder_.write("2_dry.csv", table({shifted.begin() + 30, shifted.end()}));
    expect_one();
}

TEST_F(Copies, ThatOverlapLeaveWhatIsNew) {
    // Its first 100 rows are the last ones of the first file, 300 follow.
    const auto first = measured(1), more = measured(2, 300);
    std::vector<Row> rows(first.begin() + 100, first.end());
    for (const Row& row : more)
        rows.push_back({row.time + 20, row.torque, row.gap});
    folder_.write("2_dry.csv", table(rows));
    const Measurements all = read();
    ASSERT_EQ(all.readings.size(), 2u);
    EXPECT_GE(all.readings[1].origin.line, 102);
}

TEST_F(Copies, AreNotReplicatesAtTheSameTimes) {
    // Also where three digits are all there is, so that single rows agree by chance.
    for (const std::string format : {"{:.1f},{:.4f},5,{:.5f}", "{:.1f},{:.3g},5,{:.3g}"}) {
        for (unsigned seed = 1; seed <= 6; ++seed)
            folder_.write(fmt::format("{}_dry.csv", seed), table(measured(seed), format));
        const Measurements all = read();
        EXPECT_EQ(all.readings.size(), 6u) << format;
        EXPECT_THAT(all.doubts(), IsEmpty());
    }
}

TEST_F(Copies, WithinOneFileCountOnce) {
    // The file twice, one after the other, as its interval shows.
    std::string text =
        "Time [s],Torque [mN m],Normal force [N],Gap [mm],Angular velocity [rad/s],Interval\n";
    for (int interval : {1, 2})
        for (const Row& row : measured(1))
            text += fmt::format("{},{},5,{},0.1,{}\n", row.time, row.torque, row.gap, interval);
    folder_.write("1_dry.csv", text);
    EXPECT_EQ(read().readings.size(), 1u);
}

TEST_F(Copies, ThatAreSaidToBeWetterAreDoubted) {
    folder_.write("2_wet.csv", table(measured(1)));
    folder_.write("study.toml", study_text +
                                    "[[recording]]\nfile = \"2_wet.csv\"\n"
                                    "liquid_content = 0.03\n[liquid]\n"
                                    "surface_tension = \"20.6 mN/m\"\n"
                                    "contact_angle = \"0 deg\"\n");
    const Measurements all = read();
    EXPECT_EQ(all.readings.size(), 1u);
    ASSERT_EQ(all.doubts().size(), 1u);
    EXPECT_EQ(all.doubts()[0].quantity, "liquid_content");
    expect_told({text_of(all.doubts()[0])});
}

const std::string head = "normal_stress [Pa],stress_ratio,solid_fraction,inertial_number\n";
const std::string readings_entry = "[[readings]]\nfile = \"*points.csv\"\nliquid_content = 0\n";

TEST_F(Copies, OfReadingsCountOnce) {
    folder_.write("study.toml", study_text.substr(0, study_text.find("[[")) + readings_entry);
    folder_.write("a_points.csv", head + "1000,0.25,0.61,0\n1000,0.26,0.61,0\n1000,0.25,0.61,0\n");
    folder_.write("b_points.csv", head + "1000,0.260,0.610,0\n1000,0.27,0.61,0\n");
    const Measurements all = read();
    ASSERT_EQ(all.readings.size(), 3u);
    EXPECT_EQ(all.readings[0].replicates, 3);
    expect_told(told_of(all));
}

TEST_F(Copies, OfRecordingsAsReadingsCountOnce) {
    folder_.write("2_dry.csv", table(measured(2)));
    write_readings(folder_.path() / "points.csv", read());
    folder_.write("study.toml", study_text + "[[readings]]\nfile = \"points.csv\"\n");
    EXPECT_EQ(read().readings.size(), 2u);
}

}  // namespace pendular::data_copies_test
