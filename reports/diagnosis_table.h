#pragma once

#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"

namespace pendular {

/// Returns the power of the score test of an effect (test without a refit) as text, such as "0.83".
/// The power is the probability [1] that the readings show an effect of the smallest size of
/// interest. The text is "-" if the test is significant (p < 0.05), since the power matters only
/// for a test that found no effect.
/// @param finding result of the test
std::string power_text(const Finding& finding);

/// Returns the estimate of the first parameter of an effect as text, with standard error and unit.
/// The estimate comes from a refit of the model with the effect or, if no converged refit
/// determines the parameter, from the score test (test without a refit). An estimate at a bound of
/// the parameter has no standard error. For an effect that is on or off, the text is "switch".
/// @param finding result for the effect, an element of `diagnosis.scan`
std::string estimate_of(const Diagnosis& diagnosis, const Finding& finding,
                        const ModelSpace& space);

/// Returns the text of chi2 per degree of freedom [1] that is left with an effect in the model,
/// such as "1.40", or "~1.62" if the value is predicted without a refit.
/// @param finding result for the effect, an element of `diagnosis.scan`
std::string remaining_chi2_text(const Diagnosis& diagnosis, const Finding& finding,
                                const ModelSpace& space);

/// Returns a table of the effects that a diagnosis tested, one line per effect below a heading.
/// Effects that the verdict names come first, then effects with the largest reduction of chi2. A
/// line states the fitted value of the effect's parameter, chi2 per degree of freedom with the
/// effect in the model, and the decision on the effect. The last lines explain the columns.
/// @param all whether the table also has the columns of the statistical tests: share of the effect
///        that fitted parameters imitate [%], power [1] and p value [1]
std::vector<std::string> diagnosis_table(const Diagnosis& diagnosis, const ModelSpace& space,
                                         bool all);

}  // namespace pendular
