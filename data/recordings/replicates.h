#pragma once

#include <optional>

#include "data/reading.h"
#include "data/study/stated_scatter.h"

namespace pendular {

/// Finds replicates among readings whose covariance is that within their runs, counts them, and
/// adds the scatter between them that their own errors do not explain. Covariances are of
/// (shear stress [Pa], solid fraction [1]).
///
/// Logarithms of stress ratios and of solid fractions are compared, so that set points that differ
/// by 2 % do not count as scatter. A two-way analysis of variance (conditions, files) separates
/// scatter from step to step from the error that all steps of a filling, which is a file, share:
///     value = condition (1 + filling + step),   sd(step) ~ (normal stress)^-exponent.
/// Step scatter is estimated for files that replicate each other, drawn towards that of all as far
/// as they agree (`moderated`); filling errors are pooled over all files, with a usual size (half
/// the scatter of a step) that counts like one difference, and stand in `Reading::shared`.
/// Files or readings far away from their replicates are named in a note, left out of the pooling,
/// and weigh as little as their distance says.
///
/// With nu degrees of freedom, a variance is widened by (t_nu/2)^2, t_nu Student's quantile at the
/// level of two standard deviations: two of the standard errors then cover 95 % although the
/// scatter itself is an estimate (1.28 times for nu = 6, 7 times for one pair, where a note says
/// so). The correlation between the two observables is pooled and shrunk by (nu - 1)/(nu + 1),
/// since with few replicates it is +-1 by chance.
///
/// Scatter stated in the study replaces all that. Readings of recordings without any replicate in
/// the study, and values without any error, are given 2 %; `error_assumed` is set and a note says
/// so: errors within a recording are not the error of a measurement.
void pool_replicates(Measurements& measurements,
                     const std::optional<StatedScatter>& stated = std::nullopt);

}  // namespace pendular
