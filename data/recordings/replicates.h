#pragma once

#include <optional>

#include "data/reading.h"
#include "data/study/stated_scatter.h"

namespace pendular {

/// Adds the scatter between replicates to the covariances of (shear stress [Pa], solid
/// fraction [1]) of all readings, as far as the readings' own errors do not explain it. Also sets
/// the number of replicates of each reading and adds doubts and notes.
///
/// Logarithms of stress ratios and of solid fractions are compared, so that set points that differ
/// by 2 % do not count as scatter. A two-way analysis of variance (conditions, files) separates the
/// scatter from step to step from the error that all steps of a filling share; a file is a filling:
///     value = condition (1 + filling + step),   sd(step) ~ (normal stress)^-exponent.
/// Step scatter is estimated for each cluster of files with common conditions, and shrunk towards
/// the scatter of all clusters (`moderated`). Filling errors are pooled over all files, with a
/// prior of half the scatter of a step that weighs like one difference between files; they are in
/// `Reading::shared`. Files or conditions far from their replicates make a doubt, are left out of
/// the pooling, and get an error as large as their distance (`set_far_replicates_apart`).
///
/// A variance with nu degrees of freedom is widened by (t_nu/2)^2, with t_nu Student's quantile at
/// the level of two standard deviations, so that two standard errors cover 95 % although the
/// scatter is an estimate: standard errors increase 1.28 times for nu = 6, and 7 times for one
/// pair, which makes a note. The correlation between the observables is pooled and shrunk by
/// (nu - 1)/(nu + 1), since with few replicates it is near +-1 by chance.
///
/// @param stated scatter stated by the user, which replaces the estimated scatter. Without it,
///        readings of recordings get an error of 2 % if the study has no replicates, since the
///        scatter within a recording is not the error of a measurement; values without any error
///        get 2 % as well. Then `error_assumed` is set and a note is added.
void pool_replicates(Measurements& measurements,
                     const std::optional<StatedScatter>& stated = std::nullopt);

}  // namespace pendular
