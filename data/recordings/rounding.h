#pragma once

#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Returns the correlation [1] between the rounding errors of two measurements of one quantity,
/// averaged over all positions of the true value between two rounded values.
///     6/pi^2 sum_k exp(-(2 pi k scatter)^2)/k^2      (Fourier series of the rounding error)
/// The correlation is near 1 if the scatter is far below 1.
/// @param scatter standard deviation of the measurements before rounding, divided by the rounding
///         step [1]
double rounding_correlation(double scatter);

/// Sets `ReplicatedValue::rounding` = V/T [1] of the rounded values in a table of replicates
/// (repeated readings at one condition), so that `analyse_scatter` gives less weight to values
/// whose deviations may be due to rounding.
/// - V is the relative variance of the part of the rounding error that replicates do not have in
///   common.
/// - T is the relative variance between repetitions of a step. The function chooses one T for the
///   stress ratio and one for the solid fraction, with which the mean of squared deviation/(T + V)
///   over all deviations is 1.
/// Source: Paule and Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377.
void weigh_rounding(ReplicateTable& table, const std::vector<Reading>& readings);

/// Adds the variance of rounding, (rounding step)^2/12, to the variances of shear stress and solid
/// fraction of each reading. A value whose stated variance is at least as large is left unchanged.
/// The rounding error that replicates (repeated readings at one condition) have in common is also
/// added to `Reading::shared`.
/// @param stated variances given with each reading, including rounding, of the shear stress [Pa^2]
///         (index 0) and the solid fraction [1] (index 1); 0: no variance was given
void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  std::vector<Reading>& readings);

}  // namespace pendular
