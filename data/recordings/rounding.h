#pragma once

#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Returns the correlation [1] between the rounding errors of two measured values with equal mean,
/// averaged over all positions of the mean between two rounded values:
///     6/pi^2 sum_k exp(-(2 pi k scatter)^2)/k^2      (Fourier series of the rounding error)
/// The correlation is near 1 if the values scatter far less than the rounding step.
/// @param scatter standard deviation of the values before rounding, divided by the rounding step
///         [1]
double rounding_correlation(double scatter);

/// Sets `ReplicatedValue::rounding` [1] of the rounded values in a table, so that `analyse_scatter`
/// gives less weight to values whose deviations may be due to rounding. `ReplicatedValue::rounding`
/// is the variance of the part of the rounding error that replicates (repeated readings at one
/// condition) do not have in common, divided by the variance T between repetitions of a step. Both
/// variances are relative to the squared value. T is determined for the stress ratio and for the
/// solid fraction so that the squared deviations, each divided by the sum of T and the variance of
/// rounding, have a mean of 1.
/// Source: Paule and Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377.
void weigh_rounding(ReplicateTable& table, const std::vector<Reading>& readings);

/// Adds the variance of rounding, (rounding step)^2/12, to the variances of shear stress and solid
/// fraction of each reading, unless the variance given with the reading is at least as large. The
/// rounding error that replicates (repeated readings at one condition) have in common is also added
/// to `Reading::shared`.
/// @param stated variances given with each reading, including rounding, of the shear stress [Pa^2]
///         (index 0) and the solid fraction [1] (index 1); 0 if no variance was given
void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  std::vector<Reading>& readings);

}  // namespace pendular
