#pragma once

#include <string>
#include <vector>

#include "workflow/study_change.h"

namespace pendular {

/// Sentence on a change of a study's model, one effect added or dropped: chi2 per degree of freedom
/// and the RMS relative error of the predicted shear stress [%], before and after the change.
std::string verdict_of(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after);

/// Table of a model's errors before and after one effect was added or dropped: chi2 per degree of
/// freedom and the RMS relative errors [%] of shear stress and solid fraction, for the readings and
/// in cross-validation (each condition predicted by a fit to the others). One row per string.
std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after);

/// Table of the fitted parameters before and after one effect was added to a model or dropped. The
/// change of a parameter is in units of its standard error before. One row per string.
std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after);

/// Advice after an effect was added to a model or dropped, as sentences: on an added effect that
/// does not improve the model, on a dropped effect, and on fitted parameters that changed by more
/// than three standard errors. `study`: the study's name as the user gave it, for commands.
std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after, const std::string& study);

}  // namespace pendular
