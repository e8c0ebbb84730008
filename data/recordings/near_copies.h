#pragma once

#include <vector>

#include "data/reading.h"

namespace pendular {

/// Finds recordings that repeat an earlier one but for a little noise, and so are no replicates: a
/// remark of kind `repeated_reading` for each of their readings, and one of kind `copied_readings`
/// for each pair of files, whose `relative` is the scatter between the two [1].
///
/// Steps of two recordings that have one number and one condition are compared, stress ratio and
/// solid fraction each by itself: d is the difference of the logarithms. Two tests, each of which
/// suffices:
/// - d is far too small for the scatter of the rows within the recordings: every replicate has
///   their variances of the mean, v1 and v2, besides its errors of the step and of the filling:
///     sum d^2/(v1 + v2)     is at least a chi2 with one degree of freedom for each step.
/// - The scatter of d about its mean is far below that between the other files of the cluster (F
///   test).
///
/// Recordings with columns so coarse that their resolution limits the errors (`coarse_steps`) pass
/// the first test: they agree because they are rounded. Readings of tables are not compared:
/// whether their rows are of one filling is not known, and errors that a table states are tested by
/// `pool_replicates`.
/// @param before remarks on the recordings so far
std::vector<Remark> near_copies(const std::vector<Reading>& readings,
                                const std::vector<Remark>& before);

}  // namespace pendular
