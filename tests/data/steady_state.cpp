#include "data/recordings/steady_state.h"

#include <cmath>

#include "tests/support/golden.h"

namespace pendular::data_steady_state_test {

using testing::IsEmpty;

const GrainProperties grains{.diameter = 500e-6, .density = 1050};
// 10 g in the cell: M g/A = 20 Pa, 2 % of the 1 kPa that 5 N make.
const AnnularCell cell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 0.01 / 1050};

/// Parameters of a synthetic recording; noises are relative standard deviations.
struct Truth {
    std::size_t rows = 300;
    double torque = 0.03;
    double force = 5;
    double height = 0.004;
    double speed = 0.1;
    double torque_noise = 0.01;
    double force_noise = 0;
    double height_noise = 0.001;
    double rho = 0.5;
    double slope = 0;  ///< d torque/d force: how far the torque follows the force's fluctuations
};

Recording record(const Truth& truth, std::uint64_t seed = 1) {
    std::mt19937_64 random(seed);
    const auto torque = autoregressive(truth.rows, truth.rho, random);
    const auto force = autoregressive(truth.rows, truth.rho, random);
    const auto height = autoregressive(truth.rows, truth.rho, random);
    Recording recording;
    recording.file = "r.csv";
    for (std::size_t i = 0; i < truth.rows; ++i) {
        const double excess = truth.force * truth.force_noise * force[i];
        recording.line.push_back(static_cast<int>(i) + 2);
        recording.time.push_back(0.1 * static_cast<double>(i));
        recording.torque.push_back(truth.torque * (1 + truth.torque_noise * torque[i]) +
                                   truth.slope * excess);
        recording.normal_force.push_back(truth.force + excess);
        recording.height.push_back(truth.height * (1 + truth.height_noise * height[i]));
        recording.angular_velocity.push_back(truth.speed);
    }
    return recording;
}

Measurements reduce(const Recording& recording, const ImportSettings& choice = {}) {
    RunClock clock;
    std::vector<RecordedStep> steps = recorded_steps(recording);
    find_creep(recording.file, steps);
    return reduce_steps(steps, recording, cell, grains, 0.03, clock, choice);
}

TEST(ReduceRecording, GivesTheStateOfASteadyRecording) {
    const Truth truth;
    const Measurements found = reduce(record(truth));
    ASSERT_EQ(found.readings.size(), 1u);
    const Reading& reading = found.readings[0];
    const double rate = shear_rate(truth.speed, truth.height, cell);
    EXPECT_NEAR(reading.value(0), shear_stress(truth.torque, cell),
                4 * std::sqrt(reading.covariance(0, 0)));
    EXPECT_NEAR(reading.value(1), solid_fraction(truth.height, cell),
                4 * std::sqrt(reading.covariance(1, 1)));
    EXPECT_NEAR(reading.condition.normal_stress, normal_stress(truth.force, cell), 1e-6);
    EXPECT_NEAR(reading.shear_rate, rate, 1e-3 * rate);
    EXPECT_NEAR(reading.condition.inertial_number,
                inertial_number(rate, normal_stress(truth.force, cell), grains), 1e-3);
    EXPECT_EQ(reading.condition.liquid_content, 0.03);
    EXPECT_NEAR(*reading.condition.height, truth.height, 1e-3 * truth.height);
    EXPECT_NEAR(reading.sampled_seconds, 0.1 * 299, 6);  // less what is cut at the beginning
    EXPECT_EQ(reading.condition.bead_volume, cell.bead_volume);
    // The rows left out are the first ones, so that the mean time of the rest is half of what was
    // sampled before the end.
    EXPECT_NEAR(reading.condition.time, 0.1 * 299 - reading.sampled_seconds / 2, 1e-9);
    EXPECT_FALSE(reading.error_assumed);
    EXPECT_THAT(found.notes(), IsEmpty());
}

TEST(ReduceRecording, LetsStepsWhoseTimeRestartsFollowOneAnother) {
    Recording recording = record({}), second = record({}, 2);
    recording.interval.assign(300, 1);
    const auto append = [](auto& to, const auto& from) {
        to.insert(to.end(), from.begin(), from.end());
    };
    append(recording.time, second.time);
    append(recording.torque, second.torque);
    append(recording.normal_force, second.normal_force);
    append(recording.height, second.height);
    append(recording.angular_velocity, second.angular_velocity);
    recording.interval.resize(600, 2);
    recording.line.resize(600, 1);
    const Measurements found = reduce(recording);
    ASSERT_EQ(found.readings.size(), 2u);
    const double end = 0.1 * 299;
    for (int k = 0; k < 2; ++k) {
        const Reading& reading = found.readings[static_cast<std::size_t>(k)];
        EXPECT_NEAR(reading.condition.time, (k + 1) * end - reading.sampled_seconds / 2, 1e-9);
    }
}

TEST(RunClock, AddsUpOnlyWhereTimesRestart) {
    RunClock clock;
    EXPECT_EQ(clock.shift(0, 100), 0);
    EXPECT_EQ(clock.shift(101, 150), 0);  // goes on
    EXPECT_EQ(clock.shift(0, 20), 150);   // restarts: 150 to 170
    EXPECT_EQ(clock.shift(21, 30), 150);  // goes on to 180
    EXPECT_EQ(clock.shift(10, 12), 180);  // restarts, its first 10 s not recorded
}

TEST(ReduceRecording, HasHonestErrors) {
    // 400 recordings: the squared standardised errors average 1 with a standard deviation of
    // sqrt(2/400) = 0.07 and 10 % for the error's own bias (time_series.cpp): 0.3 is 3 of
    // both.
    const Truth truth{.force_noise = 0.01};
    double stress = 0, fraction = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const Reading reading = reduce(record(truth, seed)).readings.at(0);
        const double expected = shear_stress(truth.torque, cell) /
                                normal_stress(truth.force, cell) * reading.condition.normal_stress;
        stress += std::pow(reading.value(0) - expected, 2) / reading.covariance(0, 0);
        fraction += std::pow(reading.value(1) - solid_fraction(truth.height, cell), 2) /
                    reading.covariance(1, 1);
    }
    EXPECT_NEAR(stress / 400, 1, 0.3);
    EXPECT_NEAR(fraction / 400, 1, 0.3);
}

TEST(ReduceRecording, TakesTheErrorOfTheNormalForceIntoTheShearStress) {
    // The torque follows a force that fluctuates (slope T/F): the fluctuations cancel. The force
    // only reads wrong (slope 0): its error, taken through the stress ratio, adds.
    Truth truth{.torque_noise = 0.001, .force_noise = 0.02};
    truth.slope = truth.torque / truth.force;
    const double follows = reduce(record(truth)).readings.at(0).covariance(0, 0);
    truth.slope = 0;
    const double reads_wrong = reduce(record(truth)).readings.at(0).covariance(0, 0);
    truth.force_noise = 0;
    const double alone = reduce(record(truth)).readings.at(0).covariance(0, 0);
    EXPECT_NEAR(std::sqrt(follows / alone), 1, 0.1);
    EXPECT_NEAR(std::sqrt(reads_wrong / alone), 20, 5);  // 2 % beside 0.1 %
}

TEST(ReduceRecording, CarriesTheCorrelationOfTorqueAndGap) {
    Recording recording = record({});
    for (std::size_t i = 0; i < recording.size(); ++i)  // a lower gap with a higher torque
        recording.height[i] = 0.004 * (1 - 0.05 * (recording.torque[i] / 0.03 - 1));
    const Eigen::Matrix2d covariance = reduce(recording).readings.at(0).covariance;
    EXPECT_GT(covariance(0, 1), 0.9 * std::sqrt(covariance(0, 0) * covariance(1, 1)));
    EXPECT_EQ(covariance(0, 1), covariance(1, 0));
    EXPECT_LT(covariance(0, 1), std::sqrt(covariance(0, 0) * covariance(1, 1)));  // invertible
}

TEST(ReduceRecording, CutsTheTransientAndListsIt) {
    Recording recording = record({});
    for (std::size_t i = 0; i < recording.size(); ++i)
        recording.height[i] *= 1 + 0.05 * std::exp(-static_cast<double>(i) / 10);
    const Measurements found = reduce(recording);
    ASSERT_EQ(found.readings.size(), 1u);
    ASSERT_EQ(found.left_out().size(), 1u);
    EXPECT_EQ(found.left_out()[0].file(), "r.csv");
    EXPECT_EQ(found.left_out()[0].first_line(), 2);
    EXPECT_GT(found.left_out()[0].last_line(), 20);  // exp(-20/10) 5 % is still seven noises
    EXPECT_EQ(found.left_out()[0].last_line() + 1, found.readings[0].origin.line);
    expect_told({text_of(found.left_out()[0])});
    EXPECT_NEAR(found.readings[0].value(1), solid_fraction(0.004, cell), 5e-4);
}

TEST(ReduceRecording, LeavesOutAStepThatNeverSettles) {
    Recording recording = record({});
    for (std::size_t i = 0; i < recording.size(); ++i)
        recording.torque[i] *= 1 + 0.001 * static_cast<double>(i);
    const Measurements found = reduce(recording);
    EXPECT_THAT(found.readings, IsEmpty());
    ASSERT_EQ(found.left_out().size(), 1u);
    EXPECT_EQ(found.left_out()[0].first_line(), 2);
    EXPECT_EQ(found.left_out()[0].last_line(), 301);
    expect_told({text_of(found.left_out()[0])});
}

TEST(ReduceRecording, KeepsAStepWhoseGapCreepsByLessThanATenthOfAPercent) {
    Recording recording = record({.height_noise = 1e-6});
    for (std::size_t i = 0; i < recording.size(); ++i)
        recording.height[i] *= 1 - 1e-6 * static_cast<double>(i);
    EXPECT_EQ(reduce(recording).readings.size(), 1u);
}

/// A recording whose gap changes by `change` of its value, in proportion to time.
Recording creeping(double change, double torque_drift = 0) {
    Recording recording = record({});
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const double t = static_cast<double>(i) / 299;
        recording.height[i] *= 1 + change * t;
        recording.torque[i] *= 1 + torque_drift * t;
    }
    return recording;
}

TEST(ReduceRecording, UsesTheTorqueOfABedThatCreeps) {
    // Strain 30 s x 0.1 rad/s x 33 mm/4 mm = 25.
    const Measurements found = reduce(creeping(-0.01));
    ASSERT_EQ(found.readings.size(), 1u);
    const Reading& reading = found.readings[0];
    EXPECT_NEAR(reading.value(0), shear_stress(0.03, cell),
                4 * std::sqrt(reading.covariance(0, 0)));
    EXPECT_NEAR(reading.condition.gap_creep, -0.01 / 24.7, 1e-4);
    EXPECT_DOUBLE_EQ(reading.covariance(1, 1), 0.01);  // the solid fraction counts as unknown
    EXPECT_EQ(reading.covariance(0, 1), 0);
    EXPECT_EQ(reduce(record({})).readings.at(0).condition.gap_creep, 0);
}

TEST(ReduceRecording, HardlyEverTakesNoiseOfTheGapForCreep) {
    // Correlated over some twenty rows, so that one in a hundred steps never counts as steady.
    int creeping = 0;
    for (std::uint64_t seed = 0; seed < 500; ++seed)
        for (const Reading& each : reduce(record({.rho = 0.9}, seed)).readings)
            creeping += each.condition.gap_creep != 0;
    EXPECT_LE(creeping, 1);
}

TEST(ReduceRecording, LeavesOutABedThatConsolidatesOrWhoseTorqueChangesToo) {
    const Measurements fast = reduce(creeping(-0.04)), both = reduce(creeping(-0.01, 0.3));
    EXPECT_THAT(fast.readings, IsEmpty());
    EXPECT_THAT(both.readings, IsEmpty());
    expect_told({text_of(fast.left_out().at(0)), text_of(both.left_out().at(0))});
}

TEST(ReduceRecording, LeavesOutStepsOfTooFewRows) {
    const Measurements found = reduce(record({.rows = 19}));
    EXPECT_THAT(found.readings, IsEmpty());
    expect_told({text_of(found.left_out().at(0))});
}

TEST(ReduceRecording, LeavesOutWhatIsNoShear) {
    expect_told({text_of(reduce(record({.speed = 0})).left_out().at(0)),
                 text_of(reduce(record({.force = -5})).left_out().at(0)),
                 text_of(reduce(record({.torque_noise = 50})).left_out().at(0))});
}

/// Reason given for a recording of 0.07 strains, shaped by a function of the way through it.
std::string short_recording(const std::function<void(Recording&, std::size_t, double)>& shape) {
    Recording recording = record({.speed = 0.0003});
    for (std::size_t i = 0; i < recording.size(); ++i)
        shape(recording, i, static_cast<double>(i) / 300);
    const Measurements found = reduce(recording);
    EXPECT_THAT(found.readings, IsEmpty());
    return text_of(found.left_out().at(0));
}

TEST(ReduceRecording, LeavesOutStepsOfLessThanAStrainAndSaysWhatTheyLookLike) {
    // 0.0003 rad/s at 33 mm over 4 mm: 2.5e-3/s for 29.9 s, 0.074.
    expect_told({short_recording([](Recording&, std::size_t, double) {}),
                 short_recording([](Recording& r, std::size_t i, double t) {
                     r.torque[i] *= t < 0.3 ? t / 0.3 : 1 - 0.3 * (t - 0.3);
                 }),
                 short_recording([](Recording& r, std::size_t i, double t) { r.torque[i] *= t; }),
                 short_recording([](Recording& r, std::size_t i, double t) {
                     r.normal_force[i] *= 1 - 0.5 * t;
                 }),
                 short_recording([](Recording& r, std::size_t i, double t) {
                     r.normal_force[i] *= 1 + 0.5 * t;
                 }),
                 short_recording(
                     [](Recording& r, std::size_t i, double t) { r.height[i] *= 1 - 0.03 * t; })});
}

TEST(ReduceRecording, TakesALeastStrainOfTheSteadyPart) {
    // 0.825/s for 29.9 s: 24.7 strains.
    const auto count = [](double least) {
        return reduce(record({}), {.least_strain = least}).readings.size();
    };
    EXPECT_EQ(count(20), 1u);
    EXPECT_EQ(count(26), 0u);
}

TEST(ReduceRecording, NumbersStepsAndReducesEach) {
    Recording recording = record({});
    for (std::size_t i = 0; i < recording.size(); ++i)
        recording.interval.push_back(i < 150 ? 3 : 7);
    const Measurements found = reduce(recording);
    ASSERT_EQ(found.readings.size(), 2u);
    EXPECT_EQ(found.readings[0].step, 1);
    EXPECT_EQ(found.readings[1].step, 2);
    EXPECT_GE(found.readings[1].origin.line, 152);
}

TEST(ReduceRecording, FlipsAWhollyNegativeTorqueWithANote) {
    const Reading expected = reduce(record({})).readings.at(0);
    Recording recording = record({});
    for (double& torque : recording.torque)
        torque = -torque;
    const Measurements found = reduce(recording);
    EXPECT_DOUBLE_EQ(found.readings.at(0).value(0), expected.value(0));
    ASSERT_EQ(found.notes().size(), 1u);
    expect_told({text_of(found.notes()[0])});
}

TEST(ReduceRecording, RefusesATorqueOfBothSigns) {
    const auto error = [](const std::function<double(std::size_t)>& sign) {
        Recording recording = record({});
        for (std::size_t i = 0; i < recording.size(); ++i)
            recording.torque[i] *= sign(i);
        return input_error([&] { reduce(recording); });
    };
    const auto half = [](std::size_t i) { return i < 200 ? 1.0 : -1.0; };
    const auto few = [](std::size_t i) { return i >= 100 && i < 108 ? -1.0 : 1.0; };
    const auto weak = [](std::size_t i) { return i < 200 ? -1.0 : 0.1; };
    const auto alternating = [](std::size_t i) { return i % 3 ? 1.0 : -1.0; };
    const auto wave = [](std::size_t i) { return std::sin(0.05 * static_cast<double>(i)); };
    expect_told({error(half), error(few), error(weak), error(alternating), error(wave)});
}

TEST(ReduceRecording, TakesSingleTorquesOfTheOtherSignForSpikes) {
    const Reading expected = reduce(record({})).readings.at(0);
    Recording recording = record({});
    recording.torque[150] = recording.torque[220] = -0.999;
    const Measurements found = reduce(recording);
    ASSERT_EQ(found.readings.size(), 1u);
    EXPECT_NEAR(found.readings[0].value(0), expected.value(0),
                3 * std::sqrt(expected.covariance(0, 0)));
    EXPECT_EQ(std::ranges::count(found.remarks, Remark::Kind::spike, &Remark::kind), 2);
}

TEST(ReduceRecording, NamesNoSpikesBeforeTheSteadyPart) {
    Recording recording = record({});
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const double after = static_cast<double>(i) - 10;
        recording.torque[i] *= after < 0 ? 0.1 : 1 + 4 * std::exp(-3 * after);
    }
    const Measurements found = reduce(recording);
    ASSERT_EQ(found.readings.size(), 1u);
    EXPECT_EQ(std::ranges::count(found.remarks, Remark::Kind::spike, &Remark::kind), 0);
}

TEST(ReduceRecording, LetsTheTorqueRelaxThroughZeroWhileTheLidRests) {
    Recording recording = record({.speed = 0});
    for (std::size_t i = 0; i < recording.size(); ++i)
        recording.torque[i] *= i < 200 ? 1 : -0.1;
    expect_told({text_of(reduce(recording).left_out().at(0))});
}

TEST(ReduceRecording, TakesNoiseAroundZeroForNoise) {
    for (const double rho : {0.0, 0.5, 0.9})
        for (std::uint64_t seed = 0; seed < 50; ++seed)
            EXPECT_NO_THROW(reduce(record({.torque_noise = 100, .rho = rho}, seed)));
}

TEST(ReduceRecording, EvensOutUnevenSampling) {
    // Rows logged ten times denser while the torque is high by 2 %: their plain mean would be
    // 1.8 % too high, the mean over time is 1 %.
    Recording recording = record({.rows = 550, .torque_noise = 1e-4});
    double time = 0;
    for (std::size_t i = 0; i < recording.size(); ++i) {
        const bool dense = i % 55 < 50;
        recording.time[i] = time;
        time += dense ? 0.1 : 1;
        if (dense) recording.torque[i] *= 1.02;
    }
    const Measurements found = reduce(recording);
    EXPECT_NEAR(found.readings.at(0).value(0), 1.01 * shear_stress(0.03, cell),
                0.0015 * shear_stress(0.03, cell));
    expect_told({text_of(found.notes().at(0))});
}

}  // namespace pendular::data_steady_state_test
