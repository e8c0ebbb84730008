#pragma once

#include <vector>

#include "data/recordings/findings/finding.h"

namespace pendular {

/// Significance level of the search for each kind of finding [1]: probability that chance alone
/// gives a finding of this kind in the recordings of a study without any fault. With six kinds,
/// chance gives a finding in at most 3 % of such studies; the remainder to an allowed 5 % covers
/// the approximations in the distributions of the test statistics.
constexpr double finding_significance = 0.005;

/// Findings of one kind that are significant among all tests of this kind in a study, by the
/// procedure of Benjamini and Hochberg: the k smallest p values with p_k <= alpha k/tests. If
/// nothing is wrong, the probability of any finding is alpha = `finding_significance`; if many
/// steps show the same, each needs less evidence.
/// @param tested one entry for each test made, significant or not
/// Source: Benjamini and Hochberg, J. R. Stat. Soc. B 57 (1995) 289.
std::vector<RecordingFinding> significant_findings(std::vector<RecordingFinding> tested);

/// Probability of a standard normal deviate farther from zero than z [1], with Student's law of
/// `freedom` degrees of freedom in place of the normal law.
double two_sided_p(double z, double freedom);

}  // namespace pendular
