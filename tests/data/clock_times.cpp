// Clock times in place of seconds.
#include "data/files/formats/clock_times.h"

#include "data/files/formats/layouts.h"
#include "data/recordings/recording.h"
#include "tests/support/golden.h"

namespace pendular::data_clock_times_test {

using testing::ElementsAre;

double seconds_of(const char* text) {
    const auto time = clock_time(text);
    return time ? time->seconds : -1;
}

TEST(ClockTime, IsReadInItsCommonForms) {
    EXPECT_DOUBLE_EQ(seconds_of("01:02:03.5"), 3723.5);
    EXPECT_DOUBLE_EQ(seconds_of("01:02:03,5"), 3723.5);
    EXPECT_DOUBLE_EQ(seconds_of("100:00:00"), 360000);
    EXPECT_DOUBLE_EQ(seconds_of("12:00:01 AM"), 1);
    EXPECT_DOUBLE_EQ(seconds_of("1:00:00 PM"), 46800);
    EXPECT_DOUBLE_EQ(seconds_of("1970-01-02T00:00:01Z"), 86401);
    EXPECT_DOUBLE_EQ(seconds_of("2.1.1970 00:00:01"), 86401);
    EXPECT_DOUBLE_EQ(seconds_of("01/02/1970 00:00:01"), 1);  // the order is not known
    for (const char* text : {"1:02", "01:62:00", "1.5", "31.2.2024 01:00:00", "13:00:00 PM", ""})
        EXPECT_FALSE(clock_time(text)) << text;
}

class ClockTimes : public testing::Test {
  protected:
    std::filesystem::path table(const std::string& time, const std::vector<std::string>& times) {
        std::string text =
            time + ";Torque [mN m];Normal force [N];Gap [mm];Angular velocity [rad/s]\n";
        for (const std::string& each : times)
            text += each + ";20;5;6;0.5\n";
        return folder_.write("t.csv", text);
    }
    TemporaryFolder folder_;
};

TEST_F(ClockTimes, BecomeSecondsWhateverTheHeaderSays) {
    for (const std::string name : {"Time", "Uhrzeit", "Heure", "Time [s]", "Time [h]"})
        EXPECT_THAT(read_recording(table(name, {"23:59:58", "23:59:59.5", "00:00:01"})).time,
                    ElementsAre(0, 1.5, 3))
            << name;
}

TEST_F(ClockTimes, NeedNoUnitInATableWithARowOfUnits) {
    const auto path =
        folder_.write("u.csv", "Point,Time,Torque [N m]\n1,10:00:00,1\n2,10:00:02,2\n");
    const BlockFile file = read_blocks(path);
    EXPECT_EQ(file.layout, "unit-row");
    EXPECT_EQ(file.blocks[0].table.rows[1].cells[1].text, "2.000000");
}

TEST_F(ClockTimes, CountTheDaysBetweenDatesWithSlashes) {
    const auto times = [&](const std::vector<std::string>& texts) {
        return read_recording(table("Time", texts)).time;
    };
    // One order alone has these months.
    EXPECT_THAT(times({"3/13/2024 10:00:00", "3/14/2024 11:00:00"}), ElementsAre(0, 90000));
    EXPECT_THAT(times({"31/3/2024 10:00:00", "1/4/2024 10:00:00"}), ElementsAre(0, 86400));
    EXPECT_THAT(times({"2024/3/1 10:00:00", "2024/3/2 10:00:00"}), ElementsAre(0, 86400));
    EXPECT_THAT(times({"20240301 10:00:00", "20240302 10:00:00"}), ElementsAre(0, 86400));
    // One date in all rows tells nothing, as where a run goes past midnight.
    EXPECT_THAT(times({"3/1/2024 23:59:59", "3/1/2024 00:00:01"}), ElementsAre(0, 2));
    expect_told({input_error([&] { times({"3/1/2024 10:00:00", "3/2/2024 11:00:00"}); })});
}

TEST_F(ClockTimes, AreRefusedBesideOtherTexts) {
    expect_told({input_error([&] { read_recording(table("Time [s]", {"10:00:00", "soon"})); })});
}

}  // namespace pendular::data_clock_times_test
