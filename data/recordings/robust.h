#pragma once

#include <span>
#include <vector>

namespace pendular {

/// Median of values, in the unit of the values; 0 if there are none.
double median(std::vector<double> values);

/// Robust estimate of the standard deviation, in the unit of the values: 1.4826 times the median
/// absolute deviation from the median.
double robust_deviation(std::span<const double> values);

/// Standard deviation of the noise from sample to sample, in the unit of the series, regardless of
/// slow changes: `robust_deviation` of the differences between neighbouring samples over sqrt(2).
double sample_noise(std::span<const double> series);

/// Resolution with which values were recorded, in the unit of the values: smallest difference
/// between distinct values; 0 if all values are equal. Differences below 1e-9 of the largest value
/// are ignored as rounding errors of the arithmetic.
double least_step(std::vector<double> values);

}  // namespace pendular
