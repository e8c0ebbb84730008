#pragma once

#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Correlation [1] of the rounding errors of two values with the same mean, averaged over the
/// position of the mean between two rounded values:
///     6/pi^2 sum_k exp(-(2 pi k scatter)^2)/k^2,
/// from the Fourier series of the rounding error.
/// @param scatter standard deviation of the values over the rounding step [1]
double rounding_correlation(double scatter);

/// Sets `ReplicatedValue::rounding` of all values in the table: the relative variance of the
/// rounding error that differs between replicates, over the relative variance T of a step [1]. T is
/// chosen such that the squared deviations, each divided by T plus the variance of rounding, have a
/// mean of 1.
/// Source: Paule and Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377.
void weigh_rounding(ReplicateTable& table, const std::vector<Reading>& readings);

/// Adds the error of rounding, of variance resolution^2/12, to the covariances of the readings,
/// unless their stated variance is larger. The part that replicates have in common is added to
/// `Reading::shared`.
/// @param stated variances of (shear stress [Pa^2], solid fraction [1]) given with each reading,
///        rounding included; 0 if none was given
void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  std::vector<Reading>& readings);

}  // namespace pendular
