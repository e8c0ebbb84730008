#pragma once

#include <vector>

#include "data/recordings/findings/finding.h"

namespace pendular {

/// Probability [1] that chance alone causes a finding of one kind, such as a wobble, in the
/// recordings of a faultless study. Since faults of six kinds are tested, chance causes a finding
/// in at most 3 % of faultless studies. The intended limit is 5 %. The margin covers approximations
/// in the distributions of the test statistics.
constexpr double finding_significance = 0.005;

/// Returns the findings that are significant among all tests of one kind in a study, by the
/// procedure of Benjamini and Hochberg. The findings with the k smallest of N p values are
/// significant. The number k is the largest for which the k-th smallest p value is at most
/// alpha k/N, with alpha = `finding_significance`. If the recordings have no fault, at least one
/// finding is significant with the probability alpha.
/// @param tested one entry for each test, significant or not
/// Source: Benjamini and Hochberg, J. R. Stat. Soc. B 57 (1995) 289.
std::vector<RecordingFinding> significant_findings(std::vector<RecordingFinding> tested);

/// Returns the two-sided p value [1]: probability that a variable with Student's t distribution is
/// farther from zero than z; 1 if z is not a number. At least one degree of freedom is assumed.
/// @param z estimate divided by its standard error [1]
/// @param freedom degrees of freedom of the standard error
double two_sided_p(double z, double freedom);

}  // namespace pendular
