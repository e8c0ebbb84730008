#pragma once

#include <string>
#include <vector>

#include "workflow/study_change.h"

namespace pendular {

/// Sentence that says by how much a study's model improved when an effect was added or dropped:
/// chi2 per degree of freedom and the RMS relative error of the predicted shear stress [%], before
/// and after the change.
std::string verdict_of(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after);

/// Table of a model's errors before and after one effect was added or dropped, one row per string:
/// chi2 per degree of freedom, and the RMS relative errors [%] of shear stress and solid fraction.
/// Further rows contain the RMS errors of the cross-validation, if there is one: each condition is
/// predicted by a fit to the other conditions.
std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after);

/// Table of a model's fitted parameters before and after one effect was added or dropped, one row
/// per string. The last column is the change of the parameter over its standard error before the
/// change.
std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after);

/// Sentences of advice after an effect was added to a model or dropped, one per string: on an added
/// effect that does not improve the model, on a dropped effect, and on fitted parameters that
/// changed by more than three standard errors.
/// @param study the study's name as the user gave it, for commands
std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after, const std::string& study);

}  // namespace pendular
