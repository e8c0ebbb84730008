#pragma once

#include <span>
#include <vector>

namespace pendular {

/// Returns the median of a list of values, in the unit of the values; 0 if the list is empty.
double median(std::vector<double> values);

/// Returns a robust estimate of the standard deviation of values, in the unit of the values: 1.4826
/// times the median absolute deviation from the median.
double robust_deviation(std::span<const double> values);

/// Returns the standard deviation of the noise between neighbouring values of a series, in the unit
/// of the series: the `robust_deviation` of the differences between neighbouring values, divided by
/// sqrt(2). Slow changes of the series hardly contribute.
double sample_noise(std::span<const double> series);

/// Returns the resolution at which values were recorded, in the unit of the values: the smallest
/// difference between distinct values, or 0 if all values are equal. Differences below 1e-9 of the
/// largest value are ignored as rounding errors of the arithmetic.
double least_step(std::vector<double> values);

}  // namespace pendular
