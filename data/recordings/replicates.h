#pragma once

#include <optional>

#include "data/reading.h"
#include "data/study/stated_scatter.h"

namespace pendular {

/// Estimates the scatter between replicates (repeated readings at one condition) and adds the
/// scatter to the covariance matrix of each reading (`Reading::covariance`). The contribution to
/// the scatter that follows from the readings' own errors is subtracted. The function also sets
/// `Reading::replicates` and adds messages to `measurements.doubts` and `measurements.notes`.
///
/// Logarithms of stress ratios and of solid fractions are compared, so that set points that differ
/// by 2 % do not count as scatter. A two-way analysis of variance (by conditions and by files)
/// separates the scatter between repeated steps from the error that all steps of a filling have in
/// common. Each file counts as one filling:
///     value = condition (1 + filling + step),   sd(step) ~ (normal stress)^-exponent
/// The scatter between steps is estimated for each cluster of files with common conditions, and
/// shrunk towards the scatter of all clusters (`moderated`). Filling errors are pooled over all
/// files and listed in `Reading::shared`. The prior for the filling errors is half of the scatter
/// between steps and counts like one difference between files. Files or conditions that differ too
/// much from their replicates are reported in `measurements.doubts`, left out of the pooling, and
/// get an error as large as their distance (`set_far_replicates_apart`).
///
/// Errors that the user states with all readings of a cluster (columns `_sd`) are taken as known,
/// and no scatter is added to them, unless the replicates of all such clusters scatter
/// significantly more (chi2 test at 5 % for both observables together).
///
/// A variance with nu degrees of freedom is multiplied by (t/2)^2, where t is Student's quantile
/// for nu at the level of two standard deviations. Two standard errors then cover 95 % although the
/// scatter is an estimate. Standard errors increase 1.26 times for nu = 6, and 7 times for a single
/// pair, which causes a note. The correlation between stress ratio and solid fraction is pooled and
/// multiplied by (nu - 1)/(nu + 1), since with few replicates the estimate is near +-1 by chance.
///
/// @param stated scatter that the user states in place of the estimate. Without a stated scatter,
///         readings of recordings get an error of 2 % if the study has no replicates, since the
///         scatter within a recording is not the error of a measurement. Values without any error
///         get 2 % in any case. Wherever 2 % is assumed, `Reading::error_assumed` is set and a note
///         is added.
void pool_replicates(Measurements& measurements,
                     const std::optional<StatedScatter>& stated = std::nullopt);

}  // namespace pendular
