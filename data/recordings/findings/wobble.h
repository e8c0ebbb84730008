#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/findings/finding.h"
#include "data/recordings/findings/recorded_step.h"

namespace pendular {

/// Periodic part of a series at a whole number of periods per turn of the lid.
struct Harmonic {
    int per_turn = 1;           ///< periods per turn of the lid
    double amplitude = 0;       ///< amplitude, in the unit of the series
    double standard_error = 0;  ///< standard error of the amplitude, in the unit of the series
    double p = 1;  ///< probability that ordinary noise has as large a periodic part [1]
};

/// Rotation angle [rad] of the lid at each sample of a series, from 0: integral of the angular
/// velocity over time by the trapezoidal rule.
std::vector<double> rotation_angle(const StepSeries& series);

/// Periodic parts of a series at one and two periods per turn of the lid, by least squares of
///     a + b t + sum_q (c_q cos(q angle) + s_q sin(q angle)),   q = 1, 2.
/// The squared amplitude is compared with the noise at its own frequency: with the spectrum of the
/// autoregression that describes the residuals best, times the mean ratio of power and spectrum at
/// up to 20 neighbouring frequencies. The p value is that of an F distribution, since these
/// frequencies are few:
///     p = (1 + F/K)^-K,   F = n (c^2 + s^2)/(4 spectrum) over its mean at K frequencies.
/// Empty for less than two turns, less than eight samples a turn, less than 40 samples, and a
/// series without noise.
/// @param angle rotation angle of the lid at each sample [rad]
std::vector<Harmonic> harmonics(std::span<const double> samples, std::span<const double> angle);

/// Tests for a wobble (periodic part of torque, normal force or gap at one or two periods per turn)
/// in the steady part of each step, one entry for each test.
std::vector<RecordingFinding> wobble_tests(const std::string& file,
                                           const std::vector<RecordedStep>& steps);

/// Index of the first sample from which on a steady series covers a whole number of turns, if the
/// mean over all its samples is biased by a wobble: at least two turns, a periodic part of torque,
/// force or gap with p < 0.001, and an amplitude above the standard error of the mean. 0 otherwise.
std::size_t whole_turns_begin(const StepSeries& steady);

}  // namespace pendular
