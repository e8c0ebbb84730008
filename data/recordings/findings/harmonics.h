#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {

/// Periodic part of a series with a whole number of periods per turn of the lid.
struct Harmonic {
    int per_turn = 1;           ///< number of periods per turn
    double amplitude = 0;       ///< in the unit of the series
    double standard_error = 0;  ///< of the amplitude
    double p = 1;  ///< probability that the amplitude of noise alone is at least as large [1]
};

/// Returns the rotation angle [rad] of the lid at each data point, from 0 at the first: the angular
/// velocity integrated over time by the trapezoidal rule.
std::vector<double> rotation_angle(const StepSeries& series);

/// Returns the periodic parts of a series with one and two periods per turn of the lid, fitted by
/// least squares:
///     a + b t + sum_q (c_q cos(q angle) + s_q sin(q angle)),   q = 1, 2,   t: time
/// Series and waves are first whitened by an autoregressive model of the noise. The p value
/// compares c and s of each q with the whitened residuals at K neighbouring frequencies, so that it
/// holds for every spectrum that is smooth over these frequencies, whatever the model misses:
///     p = (1 + F/K)^-K,   F = (c s) C^-1 (c s)'/(2 noise)
/// C is the covariance matrix of c and s for white noise of variance 1. Of K = 6 and K = 12, the
/// larger p counts; over few turns, K is at most 0.7 for each period. Empty for less than one and a
/// half turns, eight values a turn or 40 values, and for a series without noise.
/// @param angle from `rotation_angle`
std::vector<Harmonic> harmonics(std::span<const double> samples, std::span<const double> angle);

/// Periodic parts of one column of a step, with its mean, in SI units.
struct PeriodicColumn {
    const char* quantity = "";  ///< "torque", "normal_force" or "height"
    double mean = 0;
    double mean_error = 0;  ///< standard error of the mean, autocorrelation included
    std::vector<Harmonic> harmonics;
};

/// Returns the `harmonics` of torque, normal force and gap of a step; empty where there are too few
/// turns or data points for them.
std::vector<PeriodicColumn> periodic_columns(const StepSeries& series);

/// Returns the number of data points to leave out at the beginning of a steady series so that whole
/// turns of the lid remain; 0 unless a wobble biases the mean: a periodic part of a column has
/// p < 0.001 and an amplitude above the standard error of the mean.
/// @param columns of the series, from `periodic_columns`
std::size_t whole_turns_begin(const StepSeries& steady, const std::vector<PeriodicColumn>& columns);

}  // namespace pendular
