#pragma once

#include <optional>

#include "data/reading.h"
#include "data/study/stated_scatter.h"

namespace pendular {

/// Estimates the scatter between replicates (repeated readings at one condition) and adds the
/// scatter to the covariance matrix of each reading (`Reading::covariance`). The function also sets
/// `Reading::replicates` and `Reading::shared`, and adds messages to `measurements.doubts` and
/// `measurements.notes`. A two-way analysis of variance (by conditions and by files) separates the
/// error of each step from the error of the filling of the cell, which all steps of a file share:
///     value = mean at the condition (1 + filling + step),   sd(step) ~ (normal stress)^-exponent
/// A variance with nu degrees of freedom is multiplied by (t/2)^2, so that two standard errors
/// cover 95 %. Here t is Student's quantile for nu at the probability of two standard deviations.
///
/// Errors that do not follow from this analysis:
/// - Files or conditions that differ too much from their replicates get an error as large as their
///   distance (`set_far_replicates_apart`).
/// - Errors that the user states with all readings of a cluster of files (columns `_sd`) are taken
///   as known, unless the replicates scatter significantly more.
/// - If the scatter is neither estimated nor stated, readings of recordings get an error of 2 %.
///   Values without any error get 2 % in any case. `Reading::error_assumed` marks these readings.
/// @param stated scatter that the user states in place of the estimate
void pool_replicates(Measurements& measurements,
                     const std::optional<StatedScatter>& stated = std::nullopt);

}  // namespace pendular
