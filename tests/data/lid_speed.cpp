// Rests, run-ins, staircases and reversals of the lid within one recording: what is sheared at one
// speed makes a reading, and nothing else does.
#include "data/recordings/lid_speed.h"

#include <cmath>

#include "data/recordings/file_view.h"
#include "data/recordings/steady_state.h"
#include "data/recordings/steps.h"
#include "tests/support/golden.h"

namespace pendular::data_lid_speed_test {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Part of a recording at one speed [rpm].
struct Part {
    std::size_t rows = 0;
    double speed = 0;
};

/// A recording of dry grains at 1 kPa, once a second: the torque is 30 mN m where the lid turns,
/// after a rise over some rows, and about 0 where it rests.
std::string recording(const std::vector<Part>& parts) {
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::string text = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]\n";
    int time = 0;
    for (const auto& [rows, speed] : parts) {
        for (std::size_t i = 0; i < rows; ++i) {
            const double risen = 1 - std::exp(-0.5 * static_cast<double>(i + 1));
            const double torque =
                speed == 0 ? 0.1 * normal(random) : 30 * risen * (1 + 0.006 * normal(random));
            text += fmt::format("{},{:.4f},{:.4f},{:.4f},{:.5f}\n", time++, torque,
                                5 * (1 + 0.002 * normal(random)), 6 * (1 + 0.0003 * normal(random)),
                                speed * (1 + 0.001 * normal(random)));
        }
    }
    return text;
}

const GrainProperties grains{.diameter = 500e-6, .density = 2500};
const AnnularCell cell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 0.04 / 2500};

Measurements measured(const std::string& text) {
    const TemporaryFolder folder;
    const Recording recording = read_recording(folder.write("r.csv", text));
    RunClock clock;
    return reduce_steps(recorded_steps(recording), recording, cell, grains, 0, clock, {});
}

/// Torques [mN m] and speeds [rpm] that the readings of a recording show.
std::vector<double> torques(const Measurements& found) {
    std::vector<double> result;
    for (const Reading& reading : found.readings)
        result.push_back(1e3 * torque(reading.value(0), cell));
    return result;
}

std::vector<double> speeds(const Measurements& found) {
    std::vector<double> result;
    const double rate = shear_rate(2 * M_PI / 60, 6e-3, cell);
    for (const Reading& reading : found.readings)
        result.push_back(reading.shear_rate / rate);
    return result;
}

std::string role(const std::string& text) {
    const TemporaryFolder folder;
    const FileView view = view_of_file(folder.write("r.csv", text));
    return view.roles.at(0).role + ": " + view.roles.at(0).reason;
}

/// Rows at rest or at another speed never count, however few they are: between parts of shear,
/// before the first, after the last.
TEST(ShortRests, AreNotAveraged) {
    for (const std::size_t rest : {4, 5, 8, 10, 12, 18, 19, 20, 30}) {
        const Measurements between =
            measured(recording({{60, 2}, {rest, 0}, {60, 2}, {rest, 0}, {60, 2}}));
        EXPECT_THAT(torques(between), SizeIs(3)) << rest;
        EXPECT_THAT(torques(between), Each(testing::DoubleNear(30, 0.3))) << rest;
        EXPECT_THAT(speeds(between), Each(testing::DoubleNear(2, 0.01))) << rest;
    }
    for (const std::size_t rest : {1, 2, 3, 5, 10, 15, 19, 20}) {
        for (const auto& parts :
             {std::vector<Part>{{rest, 0}, {60, 2}}, std::vector<Part>{{60, 2}, {rest, 0}},
              std::vector<Part>{{rest, 0.5}, {60, 2}}}) {
            const Measurements found = measured(recording(parts));
            EXPECT_THAT(torques(found), testing::Contains(testing::DoubleNear(30, 0.3))) << rest;
            EXPECT_THAT(speeds(found), testing::Contains(testing::DoubleNear(2, 0.01))) << rest;
        }
    }
}

TEST(ShortRests, BetweenLoadsAndSpeedsAreNotAveraged) {
    const Measurements found =
        measured(recording({{60, 2}, {8, 0}, {60, 10}, {8, 0}, {60, 2}, {6, 20}, {60, 2}}));
    EXPECT_THAT(torques(found), Each(testing::DoubleNear(30, 0.3)));
    EXPECT_THAT(speeds(found),
                testing::Pointwise(testing::DoubleNear(0.05), {2.0, 10.0, 2.0, 2.0}));
}

/// A lid whose slow speed is rounded to 0 or 0.1 rests nowhere, and neither does a noisy one.
TEST(ShortRests, AreNotSeenInRoundedOrNoisySpeeds) {
    std::mt19937_64 random(1);
    std::normal_distribution<double> normal;
    for (int seed = 0; seed < 50; ++seed) {
        std::vector<double> rounded, noisy, wave;
        for (int i = 0; i < 400; ++i) {
            rounded.push_back(0.1 * std::round(0.8 + 0.4 * normal(random)));
            noisy.push_back(1 + 0.3 * normal(random));
            wave.push_back(1 + 0.5 * std::sin(0.05 * i));
        }
        EXPECT_THAT(breaks_of_speed(rounded), testing::SizeIs(testing::Le(1u)));
        EXPECT_THAT(breaks_of_speed(noisy), IsEmpty());
        EXPECT_THAT(breaks_of_speed(wave), IsEmpty());
        EXPECT_TRUE(turns(rounded));
    }
}

TEST(Turns, ShowsBesideSpikesAndSlowRows) {
    std::mt19937_64 random(2);
    std::normal_distribution<double> normal;
    std::vector<double> spiked(300, 0.2), slow(20, 0.1), noise;
    spiked[100] = spiked[200] = 104.6;  // 999 rpm
    slow.insert(slow.end(), 20, 0.5);
    EXPECT_TRUE(turns(spiked));
    EXPECT_TRUE(turns(slow));
    int turning = 0;
    for (int seed = 0; seed < 200; ++seed) {
        noise.clear();
        for (int i = 0; i < 40; ++i)
            noise.push_back(normal(random));
        turning += turns(noise);
    }
    EXPECT_LE(turning, 6);  // 3 standard errors: 1 in 370; of few rows, more
}

TEST(SpikesOfTheSpeed, ChangeNoShearRate) {
    std::string text = recording({{300, 5}});
    std::size_t at = 0;
    for (int row = 0; row < 150; ++row)
        at = text.find('\n', at) + 1;
    const std::size_t end = text.find('\n', at), comma = text.rfind(',', end);
    text.replace(comma + 1, end - comma - 1, "500");
    EXPECT_THAT(speeds(measured(text)), ElementsAre(testing::DoubleNear(5, 0.01)));
}

TEST(StaircasesOfSpeed, AreReadStepByStep) {
    EXPECT_THAT(role(recording({{60, 2}, {60, 5}, {60, 10}, {60, 20}})),
                testing::StartsWith("stea"));
    EXPECT_THAT(role(recording({{60, 0}, {60, 2}, {60, 20}})), testing::StartsWith("steady"));
    EXPECT_THAT(role(recording({{60, 2}, {8, 0}, {60, 10}, {8, 0}, {60, 2}})),
                testing::StartsWith("steady"));
}

/// Slow waves of the speed by more than 20 % about its mean are no steady shear, wherever they
/// begin.
TEST(ChangingSpeeds, MayBeSlowWaves) {
    for (const double period : {100.0, 150.0, 300.0}) {
        for (const double phase : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
            const auto waves = [&](double part) {
                std::vector<Part> parts;
                for (int i = 0; i < 400; ++i)
                    parts.push_back({1, 5 * (1 + part * std::sin(phase + 2 * M_PI * i / period))});
                return role(recording(parts));
            };
            EXPECT_THAT(waves(0.05), testing::StartsWith("steady")) << period << ' ' << phase;
            for (const double part : {0.25, 0.3, 0.35, 0.4, 0.6})
                EXPECT_THAT(waves(part), testing::StartsWith("other: the speed of the lid changes"))
                    << part << ' ' << period << ' ' << phase;
        }
    }
}

/// Noise and rounding of a slow speed are no waves.
TEST(ChangingSpeeds, AreNoNoise) {
    std::mt19937_64 random(4);
    std::normal_distribution<double> normal;
    for (int repeat = 0; repeat < 50; ++repeat) {
        std::vector<double> noisy, rounded, alternating;
        for (int i = 0; i < 400; ++i) {
            noisy.push_back(1 + 0.3 * normal(random));
            rounded.push_back(0.1 * std::round(1.8 + 0.3 * normal(random)));
            alternating.push_back(i / 3 % 2 == 0 ? 0.03 : 0.05);
        }
        EXPECT_FALSE(varying_speed(noisy)) << repeat;
        EXPECT_FALSE(varying_speed(rounded)) << repeat;
        EXPECT_FALSE(varying_speed(alternating)) << repeat;
    }
}

TEST(FewRows, AreTold) {
    expect_told({role(recording({{3, 2}, {3, 5}, {3, 10}, {3, 20}})), role(recording({{1, 5}})),
                 role(recording({{19, 60}})), role(recording({{20, 60}}))});
}

/// The reason for which a step is not used is true of it.
TEST(ChangingSpeeds, AreToldAsWhatTheyAre) {
    const auto told = [](const std::string& text) {
        std::vector<std::string> texts;
        for (const Remark& remark : measured(text).remarks)
            texts.push_back(text_of(remark));
        return texts;
    };
    std::vector<std::string> all = told(recording({{15, 2}, {15, 5}, {15, 10}, {15, 20}}));
    std::vector<Part> triangle;
    for (int i = 0; i < 200; ++i)
        triangle.push_back({1, 0.5 + 0.3 * (i < 100 ? i : 199 - i)});
    for (const std::string& text : told(recording(triangle)))
        all.push_back(text);
    all.push_back(role(recording(triangle)));
    std::string oscillation = "Time [s],Torque [mN m],Normal force [N],Gap [mm],Speed [rpm]\n";
    for (int i = 0; i < 200; ++i)
        oscillation +=
            fmt::format("{},{:.3f},5,{},{:.3f}\n", 0.05 * i, 40 * std::sin(0.1 * M_PI * i + 0.5),
                        6 + 0.001 * (i % 3), 3 * std::cos(0.1 * M_PI * i));
    all.push_back(role(oscillation));
    expect_told(all);
}

/// A stress that only decays while the lid rests is no peak; one that rises and falls is, though
/// the speed is rounded to 0.
TEST(Relaxation, IsNoFailure) {
    std::string relaxation = "Time [s],Shear stress [Pa],Normal stress [Pa],Speed [rpm]\n";
    std::string failure = relaxation;
    for (int i = 0; i < 60; ++i) {
        relaxation += fmt::format("{},{:.2f},1000,0\n", i, 150 + 150 * std::exp(-0.1 * i));
        failure += fmt::format("{},{:.2f},1000,0\n", i,
                               300 * (1 - std::exp(-0.3 * (i + 1))) + 20 * std::exp(-0.1 * i));
    }
    expect_told({role(relaxation), role(failure)});
}

}  // namespace pendular::data_lid_speed_test
