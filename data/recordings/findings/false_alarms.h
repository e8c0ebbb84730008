#pragma once

#include <vector>

#include "data/remarks/remark.h"

namespace pendular {

/// Probability [1] that chance alone causes a finding of one kind in a faultless study. With six
/// kinds, chance causes a finding in at most 3 % of faultless studies, below the intended 5 %; the
/// margin covers approximations in the distributions of the test statistics.
constexpr double finding_significance = 0.005;

/// Returns the significant findings among all N tests of one kind in a study: those with the k
/// smallest p values, where k is the largest number for which the k-th smallest is at most
/// alpha k/N, alpha = `finding_significance`. If the recordings have no fault, at least one finding
/// is significant with the probability alpha.
/// Source: Benjamini and Hochberg, J. R. Stat. Soc. B 57 (1995) 289.
std::vector<Remark> significant_findings(std::vector<Remark> tested);

/// Returns the probability [1] that Student's t is farther from zero than z, an estimate over its
/// standard error of `freedom` degrees of freedom (fewer than 1 count as 1); 1 if z is not a
/// number.
double two_sided_p(double z, double freedom);

}  // namespace pendular
