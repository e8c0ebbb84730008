#pragma once

#include <vector>

#include "data/recordings/replicate_table.h"

namespace pendular {

/// Correlation [1] of the rounding errors of two values that were rounded to steps of 1 and scatter
/// by `scatter` (standard deviation, in steps), averaged over the place of their mean:
///     6/pi^2 sum_k exp(-(2 pi k scatter)^2)/k^2,
/// the Fourier series of the rounding error.
double rounding_correlation(double scatter);

/// Sets `rounding` of all values in the table. That is the variance of the part of rounding errors
/// that differs between replicates, divided by T, the relative variance [1] of a step. T is chosen
/// so that squared deviations, each divided by its own variance (T plus that of rounding), have a
/// mean of 1. Source: Paule and Mandel, J. Res. Natl. Bur. Stand. 87 (1982) 377.
void weigh_rounding(ReplicateTable& table, const std::vector<Reading>& readings);

/// Adds the error of rounding, of variance resolution^2/12, to the covariances of the readings; the
/// part that replicates have in common as an error that they share.
/// @param stated variances given with the readings, rounding included; 0 where none
void add_rounding(const ReplicateTable& table, const std::vector<Eigen::Vector2d>& stated,
                  std::vector<Reading>& readings);

}  // namespace pendular
