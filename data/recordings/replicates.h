#pragma once

#include <optional>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Estimates the scatter between replicates and adds it to the covariance of each reading. Also
/// sets `Reading::replicates` and `Reading::shared`, and adds doubts and notes. A two-way analysis
/// of variance separates the error of each step from that of the filling, which all steps of a file
/// share:
///     value = mean at the condition (1 + filling + step),   sd(step) ~ (normal stress)^-exponent
/// A variance with nu degrees of freedom is multiplied by (t/2)^2, t: Student's quantile for nu at
/// the probability of two standard deviations, so that two standard errors cover 95 %.
///
/// Other errors:
/// - Files or conditions that differ too much from their replicates get an error as large as their
///   distance (`set_far_replicates_apart`).
/// - Errors that the user states with all readings of a cluster of files (columns of errors) are
///   taken as known, unless the replicates scatter significantly more. A note says where replicates
///   scatter significantly more or less.
/// - Where the error of a value is neither estimated nor stated, it is 2 % of the value
///   (`Reading::error_assumed`), whatever the digits of the value.
/// - The rounding of a value is added where it exceeds the stated error (`add_rounding`).
/// @param stated scatter that the user states in place of the estimate
void pool_replicates(Measurements& measurements,
                     const std::optional<StatedScatter>& stated = std::nullopt);

}  // namespace pendular
