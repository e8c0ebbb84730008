#pragma once

#include <optional>
#include <span>
#include <vector>

#include "data/recordings/step_series.h"

namespace pendular {

/// Periodic part of a series with a whole number of periods per turn of the lid.
struct Harmonic {
    int per_turn = 1;           ///< number of periods of the variation per turn of the lid
    double amplitude = 0;       ///< amplitude of the periodic variation, in the unit of the series
    double standard_error = 0;  ///< standard error of the amplitude, in the unit of the series
    /// p value [1]: probability that the amplitude of noise alone is at least as large.
    double p = 1;
};

/// Returns the rotation angle [rad] of the lid at each data point of a step, with 0 at the first
/// data point: integral of the angular velocity over time by the trapezoidal rule.
std::vector<double> rotation_angle(const StepSeries& series);

/// Fits the periodic parts of a series with one and two periods per turn of the lid by least
/// squares:
///     a + b t + sum_q (c_q cos(q angle) + s_q sin(q angle)),   q = 1, 2,   t: time
/// Series and waves are first whitened by an autoregressive model of the noise. The p value
/// compares c and s of each q with the whitened residuals at K neighbouring frequencies, so that it
/// holds for every spectrum that is smooth over these frequencies, whatever the model misses:
///     p = (1 + F/K)^-K,   F = (c s) C^-1 (c s)'/(2 noise)
/// C is the covariance matrix of c and s for white noise of variance 1. Of K = 6 and K = 12, the
/// larger p counts; over few turns, K is at most 0.7 for each period. The result is empty for less
/// than one and a half turns, less than eight values a turn, less than 40 values, and a series
/// without noise.
/// @param angle rotation angle of the lid at each value of the series [rad]
std::vector<Harmonic> harmonics(std::span<const double> samples, std::span<const double> angle);

/// Periodic parts of one column of a step with one and two periods per turn of the lid.
struct PeriodicColumn {
    const char* quantity = "";  ///< name of the column: "torque", "normal_force" or "height"
    double mean = 0;            ///< arithmetic mean of the column, in the column's SI unit
    /// Standard error of the column's mean, autocorrelation included, in the column's SI unit.
    double mean_error = 0;
    std::vector<Harmonic> harmonics;
};

/// Returns the periodic parts of torque, normal force and gap of a step, which `harmonics` fits.
/// The result is empty for less than one and a half turns of the lid, less than eight data points a
/// turn, or less than 40 data points.
std::vector<PeriodicColumn> periodic_columns(const StepSeries& series);

/// Returns the number of data points to leave out at the beginning of a steady series so that whole
/// turns of the lid remain. The result is 0 unless a wobble of the lid biases the mean: a periodic
/// part of torque, force or gap has p < 0.001 and an amplitude above the standard error of the
/// mean.
/// @param columns periodic parts of the series, from `periodic_columns`
std::size_t whole_turns_begin(const StepSeries& steady, const std::vector<PeriodicColumn>& columns);

}  // namespace pendular
