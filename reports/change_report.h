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
/// If both models have been cross-validated (each condition predicted by a fit to the other
/// conditions), further rows contain the RMS errors of these predictions [%].
std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after);

/// Table of the fitted parameters before and after one effect was added to a model or dropped. The
/// change of a parameter has the parameter's unit. One row per string.
std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after);

/// Sentences on adding an effect to a study's model or dropping one: why the readings do not need
/// the effect, and which fitted parameters changed by more than three standard errors. Empty where
/// neither applies.
std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after);

/// Command to run after an effect was added to a study or dropped: `pendular drop` if an added
/// effect does not improve the model, else `pendular compare` if the fit can be believed, else
/// `pendular diagnose`.
/// @param believable whether the fit after the change can be believed
/// @param study the study's name as the user gave it
std::string next_after(const StudyChange& change, const LadderStep& before, const LadderStep& after,
                       bool believable, const std::string& study);

}  // namespace pendular
