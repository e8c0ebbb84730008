#pragma once

#include <span>
#include <vector>

namespace pendular {

/// Median of numbers, in their own unit; 0 for none.
double median(std::vector<double> values);

/// Spread of numbers about their median, in their own unit: 1.4826 times the median distance from
/// it, the standard deviation of normally distributed ones.
double robust_deviation(std::span<const double> values);

/// Noise of a series from sample to sample, in its own unit, blind to slow changes: the robust
/// deviation of its differences over sqrt(2).
double sample_noise(std::span<const double> series);

/// Least step between distinct values, in their own unit: the resolution they were recorded with.
/// Differences that are rounding of the arithmetic (1e-9 of the largest value) count as none; 0
/// where all values are equal.
double least_step(std::vector<double> values);

}  // namespace pendular
