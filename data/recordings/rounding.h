#pragma once

#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Returns the correlation [1] between the rounding errors of two measurements of one quantity,
/// averaged over all positions of the true value between two rounded values; near 1 if `scatter` is
/// far below 1.
///     6/pi^2 sum_k exp(-(2 pi k scatter)^2)/k^2      (Fourier series of the rounding error)
/// @param scatter standard deviation before rounding over the rounding step [1]
double rounding_correlation(double scatter);

/// Sets `ReplicatedValue::rounding` = V/T [1] of rounded values, so that `analyse_scatter` gives
/// less weight to values whose deviations may be due to rounding. V is the relative variance of
/// that part of the rounding error which replicates do not share, and T the relative variance
/// between repetitions of a step: one each for stress ratio and solid fraction, chosen so that the
/// mean of squared deviation/(T + V) is 1.
/// Source: Paule and Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377.
void weigh_rounding(ReplicateTable& table, const std::vector<Reading>& readings);

/// Adds the variance of rounding, (rounding step)^2/12, to shear stress and solid fraction of each
/// reading, except where the stated variance is at least as large. The error that replicates share
/// is also added to `Reading::shared`.
/// @param stated variances given with each reading, rounding included: shear stress [Pa^2], solid
///         fraction [1]; 0: none
void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  std::vector<Reading>& readings);

}  // namespace pendular
