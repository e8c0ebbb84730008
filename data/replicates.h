#pragma once

#include "data/reading.h"

namespace pendular {

/// Whether two readings are replicates: same liquid content, normal stress and inertial number
/// within 2 %.
bool are_replicates(const Reading& a, const Reading& b);

/// Finds replicates among
/// readings whose covariance is that within their runs, counts them, and adds the scatter between
/// them that their own errors do not explain.
///
/// The excess max(0, s_rep^2 - mean s_w^2) is pooled over all conditions, in units relative to the
/// values (of stress ratio and of solid fraction), and added to every reading: scatter of
/// preparation and of the instrument is nearly proportional to what is shown, and a condition
/// alone has too few replicates to tell its own. Stress ratios are compared, not shear stresses, so
/// that set points that differ by 2 % do not count as scatter. The correlation between the two
/// observables is pooled alike and shrunk by (nu - 1)/(nu + 1), nu the replicates' degrees of
/// freedom, since with few of them it is +-1 by chance.
///
/// A value that then has no error, neither given nor seen between replicates, is given 2 %;
/// `error_assumed` is set and a note says so.
void pool_replicates(Measurements& measurements);

}  // namespace pendular
