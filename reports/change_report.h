#pragma once

#include <string>
#include <vector>

#include "workflow/study_change.h"

namespace pendular {

/// Returns a sentence that says whether the model needs an effect to describe the readings. The
/// effect was added to a study's model or dropped from the model. The sentence states chi2 per
/// degree of freedom and the relative RMS error of the predicted shear stress [%], before and after
/// the change.
std::string verdict_of(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after);

/// Returns a table of the errors of a study's model before and after one effect was added or
/// dropped, one row per string. The rows are chi2 per degree of freedom and the relative RMS errors
/// [%] of shear stress and solid fraction. If both models have been cross-validated, further rows
/// contain the relative RMS errors [%] at conditions left out of the fit.
std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after);

/// Returns a table of the fitted parameters before and after one effect was added to a study's
/// model or dropped from the model, one row per string. The change of a parameter has the unit of
/// the parameter.
std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after);

/// Returns sentences on an effect that was added to a study's model or dropped from the model. The
/// first sentence warns if chance explains the reduction of chi2 by the effect, or if the effect
/// makes the prediction of conditions left out of the fit worse. One sentence follows for each
/// fitted parameter that changed by more than three times the larger of its standard errors before
/// and after.
std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after);

/// Returns the command to run after an effect was added to a study's model or dropped from the
/// model:
/// - `pendular drop`, if an added effect reduces chi2 by no more than chance explains, or makes the
///   prediction of conditions left out of the fit worse
/// - `pendular compare`, if nothing speaks against the fit after the change
/// - `pendular diagnose`, if something speaks against the fit, such as a large misfit
/// @param believable whether nothing speaks against the fit after the change
/// @param study the study's name as the user gave it
std::string next_after(const StudyChange& change, const LadderStep& before, const LadderStep& after,
                       bool believable, const std::string& study);

}  // namespace pendular
