#include "data/recordings/recording.h"

#include <fmt/format.h>

#include <cmath>

#include "data/recordings/steps.h"
#include "tests/support/golden.h"

namespace pendular::data_recording_test {

using testing::ElementsAre;

const std::string header = recording_header.substr(0, recording_header.size() - 1);

class ReadRecording : public testing::Test {
  protected:
    Recording read(const std::string& content) {
        return read_recording(folder_.write("r.csv", content));
    }
    std::string error(const std::string& content) {
        return input_error([&] { read(content); });
    }

    TemporaryFolder folder_;
};

TEST_F(ReadRecording, LeavesOutIntervalsToWhichTheUserGaveAnotherRole) {
    FileFormat format;
    format.roles = {{"failure", {"2"}}, {"steady", {"3"}}};
    const auto file = folder_.write("r.csv", header +
                                                 ",Interval\n1,30,5,20,0.1,1\n"
                                                 "2,31,5,20,0.1,2\n3,32,5,20,0.1,3\n");
    const Recording recording = read_recording(file, format);
    EXPECT_THAT(recording.interval, ElementsAre(1, 3));
    ASSERT_EQ(recording.left_out.size(), 1u);
    EXPECT_EQ(recording.left_out[0].first_line(), 3);
    EXPECT_EQ(text_of(recording.left_out[0]), "interval 2: failure, as stated");
    // Likewise in the layout of an instrument.
    const std::filesystem::path cell =
        std::filesystem::path(PENDULAR_SOURCE_DIR) / "tests/data/formats/unit_row.csv";
    const Recording second = read_recording(cell, {.roles = {{"preshear", {"1"}}}});
    EXPECT_THAT(second.interval, testing::Each(2));
    EXPECT_EQ(second.size(), 25u);
}

TEST_F(ReadRecording, NeedsEveryStressThatStandsInForATorque) {
    const std::string stresses =
        "Time [s],Shear stress [Pa],Normal force [N],Gap [mm],Angular velocity [rad/s]\n";
    expect_told({error(stresses + "1,300,5,20,0.1\n2,abc,5,20,0.1\n")});
    // Instruments leave cells empty where they measured nothing: these rows are left out.
    const Recording recording = read_recording(
        folder_.write("u.csv",
                      "Point No.,Time,Shear Stress,Normal Force,Gap,Speed\n"
                      ",[s],[Pa],[N],[mm],[rad/s]\n1,1,300,5,20,0.1\n2,2,,5,20,0.1\n"));
    EXPECT_THAT(recording.shear_stress, ElementsAre(300));
    ASSERT_EQ(recording.left_out.size(), 1u);
    expect_told({text_of(recording.left_out[0])});
}

TEST_F(ReadRecording, ConvertsToSi) {
    const Recording recording = read(header + ",Interval [1],Note\n1,30,5,20,0.1,1,x\n");
    EXPECT_THAT(recording.line, ElementsAre(2));
    EXPECT_THAT(recording.time, ElementsAre(1));
    EXPECT_THAT(recording.torque, ElementsAre(0.03));
    EXPECT_THAT(recording.normal_force, ElementsAre(5));
    EXPECT_THAT(recording.height, ElementsAre(0.02));
    EXPECT_THAT(recording.angular_velocity, ElementsAre(0.1));
    EXPECT_THAT(recording.interval, ElementsAre(1));
    EXPECT_THAT(recording.unused_columns, ElementsAre("Note"));
}

TEST_F(ReadRecording, TakesOtherSpellingsOrdersAndUnits) {
    const Recording recording =
        read("speed (rpm);h in um;Fn [mN];M [N.mm];t [min]\n30;2e4;5e3;30;1\n");
    EXPECT_THAT(recording.time, ElementsAre(60));
    EXPECT_THAT(recording.torque, ElementsAre(testing::DoubleNear(0.03, 1e-12)));
    EXPECT_THAT(recording.normal_force, ElementsAre(5));
    EXPECT_THAT(recording.height, ElementsAre(testing::DoubleNear(0.02, 1e-12)));
    EXPECT_THAT(recording.angular_velocity, ElementsAre(testing::DoubleNear(M_PI, 1e-12)));
}

TEST_F(ReadRecording, RefusesAMissingColumn) {
    expect_told({error("Time [s],Torque [mN m]\n1,2\n")});
}

TEST_F(ReadRecording, RefusesATimeThatGoesBackWithinAnInterval) {
    expect_told({error(header + "\n1,30,5,20,0.1\n0.5,30,5,20,0.1\n"),
                 error(header + ",Interval\n1,30,5,20,0.1,1\n0,30,5,20,0.1,1\n")});
    EXPECT_NO_THROW(read(header + ",Interval\n1,30,5,20,0.1,1\n0,30,5,20,0.1,2\n"));
}

TEST_F(ReadRecording, RefusesImpossibleCells) {
    expect_told({error(header + "\n1,30,5,0,0.1\n"),
                 error(header + ",Interval\n1,30,5,20,0.1,1.5\n"),
                 error(header + "\n1,inf,5,20,0.1\n")});
}

/// A recording whose force and speed are given per row; the rest is constant.
Recording with(const std::vector<double>& force, const std::vector<double>& speed) {
    Recording recording;
    for (std::size_t i = 0; i < force.size(); ++i)
        recording.time.push_back(0.1 * i);
    recording.line.assign(force.size(), 1);
    recording.torque.assign(force.size(), 0.03);
    recording.height.assign(force.size(), 0.02);
    recording.normal_force = force;
    recording.angular_velocity = speed;
    return recording;
}

/// Levels one after the other with normal noise, relative to each.
std::vector<double> levels(const std::vector<std::pair<double, std::size_t>>& parts, double noise,
                           unsigned seed = 1) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::vector<double> series;
    for (const auto& [level, rows] : parts)
        for (std::size_t i = 0; i < rows; ++i)
            series.push_back(level * (1 + noise * normal(random)));
    return series;
}

std::vector<std::size_t> ends(const std::vector<Step>& steps) {
    std::vector<std::size_t> result;
    for (const Step& step : steps)
        result.push_back(step.end);
    return result;
}

/// An interval in which the load changes is two steps: their mean is that of no load.
TEST(SplitSteps, FollowsTheIntervalColumnAndTheLoadWithin) {
    Recording recording = with(levels({{5, 30}, {10, 30}}, 0.01), levels({{0.1, 60}}, 0));
    recording.interval.assign(60, 1);
    for (std::size_t i = 50; i < 60; ++i)
        recording.interval[i] = 2;
    EXPECT_THAT(ends(split_steps(recording)), ElementsAre(30, 50, 60));
    // An interval of constant load is one, and ends where the column says, even if the load does
    // not change there.
    recording = with(levels({{5, 60}}, 0.01), levels({{0.1, 60}}, 0));
    recording.interval.assign(60, 1);
    std::fill(recording.interval.begin() + 50, recording.interval.end(), 2);
    EXPECT_THAT(ends(split_steps(recording)), ElementsAre(50, 60));
}

TEST(SplitSteps, FindsEachJumpOfForceOrSpeed) {
    const Recording recording =
        with(levels({{5, 100}, {10, 200}}, 0.01), levels({{0.1, 200}, {0.11, 100}}, 0.01));
    EXPECT_THAT(ends(split_steps(recording)), ElementsAre(100, 200, 300));
}

TEST(SplitSteps, FindsAJumpJustAboveFivePercentAndOneOfTheSign) {
    for (const double speed : {0.106, -0.1}) {
        const Recording recording =
            with(levels({{5, 200}}, 0), levels({{0.1, 100}, {speed, 100}}, 0.001));
        EXPECT_THAT(ends(split_steps(recording)), ElementsAre(100, 200)) << speed;
    }
}

TEST(SplitSteps, IgnoresChangesBelowFivePercent) {
    const Recording recording =
        with(levels({{5, 100}, {5.2, 100}}, 0.001), levels({{0.1, 200}}, 0.001));
    EXPECT_THAT(ends(split_steps(recording)), ElementsAre(200));
}

TEST(SplitSteps, IgnoresSpikesAndExcursionsThatReturn) {
    for (const std::size_t rows : {1, 5, 12, 18}) {
        const Recording recording =
            with(levels({{5, 100}, {9, rows}, {5, 100}}, 0.01), levels({{0.1, 200 + rows}}, 0.001));
        EXPECT_THAT(ends(split_steps(recording)), ElementsAre(200 + rows)) << rows;
    }
}

TEST(SplitSteps, IsNotFooledByNoise) {
    // 100 recordings with 5 % noise in the force and 2 % in the speed: no step is seen.
    for (unsigned seed = 0; seed < 100; ++seed) {
        const Recording recording =
            with(levels({{5, 500}}, 0.05, seed), levels({{0.1, 500}}, 0.02, seed + 1000));
        EXPECT_THAT(ends(split_steps(recording)), ElementsAre(500)) << seed;
    }
}

TEST(SplitSteps, IsNotFooledByRampsAndSlowWaves) {
    std::vector<double> wave, ramp;
    for (int i = 0; i < 500; ++i) {
        wave.push_back(5 * (1 + 0.1 * std::sin(0.05 * i)));
        ramp.push_back(0.1 * (1 + 0.01 * i));
    }
    EXPECT_THAT(ends(split_steps(with(wave, ramp))), ElementsAre(500));
}

TEST(SplitSteps, GivesTheRowsWhileALidSpinsUpToTheStepTheyLeadTo) {
    const Recording recording =
        with(levels({{5, 215}}, 0.01), levels({{0, 15}, {0.1, 100}, {0.15, 8}, {0.2, 92}}, 0.01));
    EXPECT_THAT(ends(split_steps(recording)), ElementsAre(115, 215));
}

TEST(SplitSteps, KeepsAShortRecordingWhole) {
    EXPECT_THAT(ends(split_steps(with({5, 5, 9}, {0.1, 0.1, 0.1}))), ElementsAre(3));
}

}  // namespace pendular::data_recording_test
