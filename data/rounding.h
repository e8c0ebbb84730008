#pragma once

#include <vector>

#include "data/replicate_table.h"

namespace pendular {

/// Correlation [1] of the rounding errors of two values that were rounded to steps of 1 and scatter
/// by `scatter` (standard deviation, in steps), averaged over the place of their mean:
///     6/pi^2 sum_k exp(-(2 pi k scatter)^2)/k^2,
/// the Fourier series of the rounding error.
double rounding_correlation(double scatter);

/// Adds the error of rounding, of variance resolution^2/12, to the covariances of the readings.
/// The part that replicates have in common does not show in their scatter; it is added as an error
/// that they share. The rest is added where replicates do not show it.
/// @param stated variances given with the readings, rounding included; 0 where none
/// @param scatter_known by observable: whether scatter was estimated from replicates or stated
void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  const std::array<bool, 2>& scatter_known, std::vector<Reading>& readings);

}  // namespace pendular
