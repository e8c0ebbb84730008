// The instrument of the virtual laboratory, without simulations: what it shows of states given to
// it.
#include "sim/lab/virtual_recording.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/chi_squared.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "data/recordings/steady_state.h"
#include "tests/support/data_support.h"

namespace sim_virtual_recording_test {

using namespace pendular;

const AnnularCell cell{.inner_radius = 0.021, .outer_radius = 0.045, .bead_volume = 6e-5};
const GrainProperties grains{.diameter = 5e-4, .density = 1050};

/// A state whose simulation has these standard errors, relative.
TrueState state(double ratio_error, double fraction_error) {
    return {{.normal_stress = 1000, .inertial_number = 0.01},
            {0.3, 0.3 * ratio_error, 1},
            {0.6, 0.6 * fraction_error, 1}};
}

/// Result of `import` for a recording, written to a file and read again.
Measurements imported(const Recording& recording) {
    const TemporaryFolder folder;
    const Recording read = read_recording(folder.write("run.csv", recording_csv(recording)));
    RunClock clock;
    return reduce_steps(recorded_steps(read), read, cell, grains, 0, clock, {});
}

/// Sums of squared deviations from the truth, relative, over many steps.
struct Deviations {
    double torque = 0, fraction = 0, product = 0;
    double within_torque = 0, within_fraction = 0;  ///< variances that the readings claim
    int steps = 0;
};

/// Steps of a truth of stress ratio 0.3 and solid fraction 0.6, each from a simulation of its own
/// that is off by its standard error.
Deviations deviations(const Instrument& instrument, double ratio_error, double fraction_error,
                      int recordings) {
    constexpr int steps = 20;
    std::mt19937_64 random(11);
    std::normal_distribution<double> normal;
    Deviations sum;
    for (int file = 0; file < recordings; ++file) {
        std::vector<TrueState> states(steps, state(ratio_error, fraction_error));
        for (TrueState& each : states) {
            each.stress_ratio.value *= 1 + ratio_error * normal(random);
            each.solid_fraction.value *= 1 + fraction_error * normal(random);
        }
        const Recording recording =
            record(states, cell, grains, instrument, 500 + static_cast<std::uint64_t>(file));
        for (const Reading& reading : imported(recording).readings) {
            const double torque = reading.value(0) / 300 - 1, fraction = reading.value(1) / 0.6 - 1;
            sum.torque += torque * torque;
            sum.fraction += fraction * fraction;
            sum.product += torque * fraction;
            sum.within_torque += reading.covariance(0, 0) / (300 * 300);
            sum.within_fraction += reading.covariance(1, 1) / (0.6 * 0.6);
            ++sum.steps;
        }
    }
    return sum;
}

/// Whether a sum of squares is that of independent normal deviates of this scatter, two-sided at a
/// significance of 0.001.
void expect_scatter(double sum_of_squares, int count, double scatter, const std::string& what) {
    const boost::math::chi_squared law(count);
    const double chi2 = sum_of_squares / (scatter * scatter);
    EXPECT_GT(chi2, boost::math::quantile(law, 0.0005)) << what;
    EXPECT_LT(chi2, boost::math::quantile(law, 0.9995)) << what;
}

TEST(VirtualRecording, GivesBackTheTruthWhereThereIsNoNoise) {
    std::vector<TrueState> states = {state(0.005, 0.001), state(0.005, 0.001)};
    states[1].condition = {.normal_stress = 3000, .inertial_number = 0.05};
    states[1].stress_ratio.value = 0.5;
    states[1].solid_fraction.value = 0.58;
    const Measurements found = imported(record(states, cell, grains, {.noise = 0}, 1));
    ASSERT_EQ(found.readings.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        // Seven digits are written.
        const Reading& reading = found.readings[k];
        const Condition& condition = states[k].condition;
        EXPECT_NEAR(reading.stress_ratio(), states[k].stress_ratio.value, 1e-6);
        EXPECT_NEAR(reading.value(1), states[k].solid_fraction.value, 1e-6);
        EXPECT_NEAR(reading.condition.normal_stress / condition.normal_stress, 1, 1e-6);
        EXPECT_NEAR(reading.condition.inertial_number / condition.inertial_number, 1, 1e-6);
    }
}

TEST(VirtualRecording, IsTheTruthBitForBitWithoutNoiseOrEffects) {
    const Recording recording = record({state(0, 0)}, cell, grains, {.noise = 0}, 1);
    const double rate = shear_rate_at(0.01, 1000, grains);
    EXPECT_EQ(recording.normal_force.back(), normal_force(1000, cell));
    EXPECT_EQ(recording.height.back(), height(0.6, cell));
    EXPECT_EQ(recording.torque.back(), torque(0.3 * 1000, cell));
    EXPECT_EQ(recording.angular_velocity.back(), angular_velocity(rate, height(0.6, cell), cell));
    EXPECT_EQ(recording.time[1], 20.0 / 400.0 / rate);
}

TEST(VirtualRecording, StartsWithATransientThatImportLeavesOut) {
    const Recording recording = record({state(0, 0)}, cell, grains, {.noise = 1}, 2);
    ASSERT_EQ(recording.size(), 400u);
    const double steady_torque = torque(300, cell), steady_height = height(0.6, cell);
    EXPECT_EQ(recording.torque.front(), 0);
    EXPECT_GT(*std::max_element(recording.torque.begin(), recording.torque.end()),
              1.1 * steady_torque);
    EXPECT_LT(recording.height.front(), 0.985 * steady_height);
    const Measurements found = imported(recording);
    ASSERT_EQ(found.left_out().size(), 1u);
    // 20 rows to a unit of strain: what is left out is a strain of a quarter at least, 2 at most.
    const int rows = found.left_out()[0].last_line() - found.left_out()[0].first_line() + 1;
    EXPECT_GE(rows, 5);
    EXPECT_LE(rows, 40);
}

TEST(VirtualRecording, ScattersByWhatWasAskedInAll) {
    for (const double noise : {1.0, 3.0}) {
        // Half of the scatter, a quarter of its variance, comes from the simulations.
        const double torque = noise * torque_scatter, fraction = noise * solid_fraction_scatter;
        const Deviations found =
            deviations({.noise = noise, .rows = 400}, 0.5 * torque, 0.5 * fraction, 40);
        // A step in a hundred may look unsteady by chance.
        EXPECT_GE(found.steps, 792);
        expect_scatter(found.torque, found.steps, torque, "torque");
        expect_scatter(found.fraction, found.steps, fraction, "solid fraction");
        // Errors of torque and gap are independent: r has a standard deviation of 1/sqrt(800), so
        // 0.116 is passed by chance in 0.1 % of tests.
        EXPECT_LT(std::abs(found.product / std::sqrt(found.torque * found.fraction)), 0.116);
        // The noise that the readings can see for themselves is the minor part.
        EXPECT_NEAR(std::sqrt(found.within_torque / found.steps) / torque, 0.25, 0.05);
        EXPECT_NEAR(std::sqrt(found.within_fraction / found.steps) / fraction, 0.25, 0.05);
    }
}

TEST(VirtualRecording, AddsNoFactorWhereTheSimulationScattersEnough) {
    std::vector<TrueState> states(40, state(0.02, 0.01));
    double torque = 0, fraction = 0;
    const auto found = imported(record(states, cell, grains, {.noise = 1}, 3));
    for (const Reading& reading : found.readings) {
        torque += std::pow(reading.value(0) / 300 - 1, 2);
        fraction += std::pow(reading.value(1) / 0.6 - 1, 2);
    }
    // About the value of its own simulation a step then shows noise within the step only.
    const int count = static_cast<int>(found.readings.size());
    ASSERT_GE(count, 39);
    expect_scatter(torque, count, 0.25 * torque_scatter, "torque");
    expect_scatter(fraction, count, 0.25 * solid_fraction_scatter, "solid fraction");
}

TEST(VirtualRecording, DriftsFromItsFirstStepToItsLast) {
    const std::vector<TrueState> states(3, state(0, 0));
    double torque = 0, fraction = 0;
    constexpr int recordings = 100;
    for (std::uint64_t seed = 1; seed <= recordings; ++seed) {
        const Recording still = record(states, cell, grains, {.noise = 1}, seed);
        const Recording drifting = record(states, cell, grains, {.noise = 1, .drift = 2}, seed);
        // The rest is the same: only the course of the level differs.
        EXPECT_EQ(still.torque.front(), drifting.torque.front());
        const double end = drifting.torque.back() / still.torque.back() - 1;
        const auto middle = still.size() / 2;
        EXPECT_NEAR(drifting.torque[middle] / still.torque[middle] - 1, end / 2, 1e-12);
        torque += end * end;
        const double height = drifting.height.back() / still.height.back() - 1;
        fraction += height * height;
    }
    expect_scatter(torque, recordings, 2 * torque_scatter, "torque");
    expect_scatter(fraction, recordings, 2 * solid_fraction_scatter, "solid fraction");
}

TEST(VirtualRecording, IsTheSameForTheSameSeed) {
    const std::vector<TrueState> states(2, state(0, 0));
    const auto csv = [&](std::uint64_t seed) {
        return recording_csv(record(states, cell, grains, {}, seed));
    };
    EXPECT_EQ(csv(4), csv(4));
    EXPECT_NE(csv(4), csv(5));
}

TEST(VirtualRecording, ShowsAWobbleOfTheInstrumentFromRowToRow) {
    TrueState wobbling = state(0, 0);
    wobbling.condition.time = 7;
    constexpr double period = 0.5;
    wobbling.shown = [&](double time) {
        const double height = pendular::height(0.6, cell);
        return CellState{
            .torque =
                torque(300, cell) * (1 + 0.1 * std::sin(2 * std::numbers::pi * time / period)),
            .normal_force = normal_force(1000, cell),
            .height = height,
            .angular_velocity = angular_velocity(shear_rate_at(0.01, 1000, grains), height, cell),
            .time = time};
    };
    std::vector<Condition> steps = {wobbling.condition};
    time_steps(steps, grains, {}, 0);
    const double shift = 7 - steps[0].time;  // from the time of the rows to that of the instrument
    const Recording recording = record({wobbling}, cell, grains, {.noise = 0}, 5);
    for (std::size_t k = 100; k < recording.size(); ++k) {
        const double phase = 2 * std::numbers::pi * (recording.time[k] + shift) / period;
        EXPECT_NEAR(recording.torque[k] / torque(300, cell), 1 + 0.1 * std::sin(phase), 1e-6) << k;
    }
}

}  // namespace sim_virtual_recording_test
