#pragma once

#include <span>
#include <vector>

namespace pendular {

/// Returns the median, in the unit of the values; 0 if there are none.
double median(std::vector<double> values);

/// Returns a robust standard deviation, in the unit of the values: 1.4826 times the median absolute
/// deviation from the median, which for normal values is the standard deviation.
double robust_deviation(std::span<const double> values);

/// Returns the standard deviation of the noise of a series, in its unit: `robust_deviation` of the
/// differences between neighbouring values over sqrt(2), to which slow changes hardly contribute.
double sample_noise(std::span<const double> series);

/// Returns the resolution of values, in their unit: the smallest difference between distinct
/// values; 0 if all are equal. Differences below 1e-9 of the largest value are rounding errors.
double least_step(std::vector<double> values);

}  // namespace pendular
