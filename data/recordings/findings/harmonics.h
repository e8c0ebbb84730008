#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {

/// Periodic part of a series at a whole number of periods per turn of the lid.
struct Harmonic {
    int per_turn = 1;           ///< periods per turn of the lid
    double amplitude = 0;       ///< amplitude, in the unit of the series
    double standard_error = 0;  ///< standard error of the amplitude, in the unit of the series
    double p = 1;               ///< probability that noise alone has as large a periodic part [1]
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

/// Periodic parts of one column of a step at one and two periods per turn of the lid.
struct PeriodicColumn {
    const char* quantity = "";  ///< column by name: "torque", "normal_force" or "height"
    double mean = 0;            ///< plain mean of the column, in its SI unit
    double mean_error = 0;  ///< standard error of the mean of correlated samples, in its SI unit
    std::vector<Harmonic> harmonics;
};

/// Periodic parts of torque, normal force and gap of a series (`harmonics`); empty for a series
/// that is too short for them.
std::vector<PeriodicColumn> periodic_columns(const StepSeries& series);

/// Index of the first sample from which on a steady series covers a whole number of turns, if the
/// mean over all its samples is biased by a wobble: at least two turns, a periodic part of torque,
/// force or gap with p < 0.001, and an amplitude above the standard error of the mean. 0 otherwise.
/// @param columns periodic parts of the series
std::size_t whole_turns_begin(const StepSeries& steady, const std::vector<PeriodicColumn>& columns);

}  // namespace pendular
