#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "data/recordings/findings/detectors.h"
#include "data/recordings/findings/look_inside.h"
#include "data/recordings/steady_state.h"
#include "tests/support/ordinary_recordings.h"

namespace pendular {

/// Stationary noise without anything periodic: a series of values of variance near 1.
struct StationaryNoise {
    std::string name;
    std::function<std::vector<double>(std::mt19937_64&, std::size_t)> series;
    /// Rounding of the columns, in standard deviations of their noise [1]; 0: none.
    double resolution = 0;
    /// Jitter of the times of rows, in row spacings [1], and share of rows that are missing, in
    /// gaps of 5 to 30 rows.
    double jitter = 0, missing = 0;
};

/// Autoregression x_t = a x_(t-1) + b x_(t-2) + innovation, from its stationary state.
inline std::vector<double> autoregressive(std::mt19937_64& random, std::size_t n, double a,
                                          double b = 0) {
    std::normal_distribution<double> normal;
    const double variance = (1 - b) / ((1 + b) * ((1 - b) * (1 - b) - a * a));
    std::vector<double> series;
    double before = 0, last = 0;
    constexpr int settling = 1000;
    for (int k = -settling; k < static_cast<int>(n); ++k) {
        const double next = a * last + b * before + normal(random) / std::sqrt(variance);
        before = last;
        last = next;
        if (k >= 0) series.push_back(next);
    }
    return series;
}

/// Moving average of `length` white values.
inline std::vector<double> moving_average(std::mt19937_64& random, std::size_t n,
                                          std::size_t length) {
    std::normal_distribution<double> normal;
    std::vector<double> white, series;
    for (std::size_t k = 0; k < n + length; ++k)
        white.push_back(normal(random));
    for (std::size_t k = 0; k < n; ++k) {
        double sum = 0;
        for (std::size_t j = 0; j < length; ++j)
            sum += white[k + j];
        series.push_back(sum / std::sqrt(static_cast<double>(length)));
    }
    return series;
}

/// White values after a low-pass filter of fourth order: four times an exponential mean over six
/// rows.
inline std::vector<double> low_passed(std::mt19937_64& random, std::size_t n) {
    constexpr double keep = 1 - 1.0 / 6;
    constexpr std::size_t settling = 300;
    std::normal_distribution<double> normal;
    std::array<double, 4> stage = {};
    std::vector<double> series;
    for (std::size_t k = 0; k < n + settling; ++k) {
        double in = normal(random);
        for (double& out : stage)
            in = out = keep * out + (1 - keep) * in;
        if (k >= settling) series.push_back(in / 0.166);  // its standard deviation
    }
    return series;
}

inline std::vector<StationaryNoise> stationary_noises() {
    const auto ar = [](double a, double b = 0) {
        return
            [=](std::mt19937_64& random, std::size_t n) { return autoregressive(random, n, a, b); };
    };
    const auto ma = [](std::size_t length) {
        return [=](std::mt19937_64& random, std::size_t n) {
            return moving_average(random, n, length);
        };
    };
    const auto filtered = [](std::mt19937_64& random, std::size_t n) {
        return low_passed(random, n);
    };
    return {{"white", ar(0)},
            {"AR(1) 0.5", ar(0.5)},
            {"AR(1) 0.9", ar(0.9)},
            {"AR(1) 0.97", ar(0.97)},
            {"AR(1) -0.5", ar(-0.5)},
            {"AR(2) 1.6 -0.8", ar(1.6, -0.8)},
            {"AR(2) 1.2 -0.25", ar(1.2, -0.25)},
            {"mean of 10", ma(10)},
            {"mean of 40", ma(40)},
            {"low-pass", filtered},
            {"AR(1) 0.9, rounded", ar(0.9), 1},
            {"white, rounded", ar(0), 2},
            {"AR(1) 0.9, jitter", ar(0.9), 0, 0.6},
            {"white, jitter", ar(0), 0, 0.9},
            {"AR(1) 0.9, gaps", ar(0.9), 0, 0.2, 0.1},
            {"white, gaps", ar(0), 0, 0.2, 0.1}};
}

/// Simulates a recording of three steps, at normal stresses of 0.5, 1 and 2 kPa, with 3 % of noise
/// in the torque and 0.2 % in force and gap. The lid turns 2.7, 22 and 50 times in the 90 s of the
/// steps, in an order that the seed chooses.
/// @param rows rows of a step
/// @param scatter relative scatter of the torque between steps; between recordings twice as much
inline Recording stationary_recording(const std::string& file, std::uint64_t seed,
                                      const StationaryNoise& noise, std::size_t rows = 450,
                                      const Spoil& spoil = {}, double scatter = 0.005) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    const double area = M_PI * (0.045 * 0.045 - 0.021 * 0.021);
    const double of_file = 1 + 2 * scatter * normal(random);
    std::array<double, 3> rates = {0.03, 0.25, 0.55};
    std::ranges::shuffle(rates, random);
    Recording r;
    r.file = file;
    for (int step = 0; step < 3; ++step) {
        const double stress = 500 * std::pow(2, step), rate = rates[static_cast<std::size_t>(step)],
                     duration = 90;
        const double level =
            torque(0.29 * stress, ordinary_cell) * of_file * (1 + scatter * normal(random));
        const auto a = noise.series(random, rows), b = noise.series(random, rows),
                   c = noise.series(random, rows);
        // The resolution of a column is one for all steps, in units of the noise at 0.5 kPa.
        const auto rounded = [&](double value, double deviation) {
            const double unit = noise.resolution * deviation;
            return unit > 0 ? unit * std::round(value / unit) : value;
        };
        const double least_force = area * 500, least_torque = torque(0.29 * 500, ordinary_cell);
        std::size_t gap_until = 0;
        for (std::size_t k = 0; k < rows; ++k) {
            if (noise.missing > 0 && k >= gap_until && uniform(random) < noise.missing / 17)
                gap_until = k + 5 + static_cast<std::size_t>(26 * uniform(random));
            const double spacing = duration / static_cast<double>(rows);
            const double time =
                spacing * (static_cast<double>(k) + noise.jitter * (uniform(random) - 0.5));
            if (k > 0 && k < gap_until) continue;
            const double fading = std::exp(-time / 4);
            double t = level * (1 + 0.35 * fading + 0.03 * a[k]),
                   f = area * stress * (1 + 0.002 * b[k]),
                   h = 6.15e-3 * (1 - 0.02 * fading + 0.002 * c[k]);
            if (spoil) spoil({time, 2 * M_PI * rate * time, t, f, h}, step);
            t = rounded(t, 0.03 * least_torque);
            f = rounded(f, 0.002 * least_force);
            h = rounded(h, 0.002 * 6.15e-3);
            r.line.push_back(static_cast<int>(r.line.size()) + 2);
            r.time.push_back(duration * step + time);
            r.torque.push_back(t);
            r.normal_force.push_back(f);
            r.height.push_back(h);
            r.angular_velocity.push_back(2 * M_PI * rate);
            r.interval.push_back(step + 1);
        }
    }
    return r;
}

/// Findings of all kinds in a study of simulated recordings.
/// @param spoil changes rows of the recordings: step and file are counted from 0; may be empty
inline std::vector<Remark> findings_in_noise(
    int files, std::uint64_t seed, const StationaryNoise& noise, std::size_t rows = 450,
    const std::function<void(RowOfStep, int step, int file)>& spoil = {}) {
    InsideRecordings inside;
    std::vector<Reading> readings;
    std::vector<Remark> found;
    RunClock clock;
    for (int file = 0; file < files; ++file) {
        const Spoil own = [&](RowOfStep row, int step) {
            if (spoil) spoil(row, step, file);
        };
        const Recording recording =
            stationary_recording("run_" + std::to_string(file + 1) + ".csv",
                                 1000 * seed + static_cast<std::uint64_t>(file), noise, rows, own);
        const std::vector<RecordedStep> steps = recorded_steps(recording);
        append(found, saturations(recording, steps));
        const ImportSettings import;
        inside.look_at(recording.file, steps, ordinary_cell, import.least_strain);
        const Measurements part = reduce_steps(
            steps, recording, ordinary_cell, {.diameter = 5e-4, .density = 1050}, 0, clock, import);
        readings.insert(readings.end(), part.readings.begin(), part.readings.end());
    }
    const auto more = inside.findings(readings, ordinary_cell);
    found.insert(found.end(), more.begin(), more.end());
    return found;
}

}  // namespace pendular
