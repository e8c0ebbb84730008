#pragma once

#include "data/reading.h"

namespace pendular {

/// Whether two readings are replicates: same liquid content, normal stress and inertial number
/// within 2 %.
bool are_replicates(const Reading& a, const Reading& b);

/// Finds replicates among readings whose covariance is that within their runs, counts them, and
/// adds the scatter between them that their own errors do not explain.
///
/// The excess max(0, s_rep^2 - mean s_w^2) is pooled over all conditions, in units relative to the
/// values (of stress ratio and of solid fraction), and added to every reading: scatter of
/// preparation and of the instrument is nearly proportional to what is shown, and a condition
/// alone has too few replicates to tell its own. Stress ratios are compared, not shear stresses, so
/// that set points that differ by 2 % do not count as scatter.
///
/// With nu degrees of freedom between replicates, the excess is widened by (t_nu/2)^2, t_nu
/// Student's quantile at the level of two standard deviations: two of the standard errors then
/// cover 95 % although the scatter itself is an estimate (1.28 times for nu = 6, 7 times for one
/// pair, where a note says so). The correlation between the two observables is pooled alike and
/// shrunk by (nu - 1)/(nu + 1), since with few replicates it is +-1 by chance.
///
/// A value that then has no error, neither given nor seen between replicates, is given 2 %;
/// `error_assumed` is set and a note says so.
void pool_replicates(Measurements& measurements);

/// Covariance of a reading as it was estimated, not widened for how few replicates tell it: for
/// tests whose laws allow for that.
Eigen::Matrix2d estimated_covariance(const Reading& reading, const ReplicateScatter& scatter);

}  // namespace pendular
