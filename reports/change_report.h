#pragma once

#include <string>
#include <vector>

#include "reports/output.h"
#include "workflow/study_change.h"

namespace pendular {

/// Returns a sentence that says whether the model needs the effect that was added or dropped, with
/// chi2/dof [1] and the relative RMS error of the shear stress [%] before and after the change.
std::string verdict_of(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after);

/// Returns a table of chi2/dof [1] and of the relative RMS errors [%] of shear stress and solid
/// fraction before and after the change; also of the errors at conditions left out of the fit, if
/// both models have been cross-validated.
std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after);

/// Returns a table of the fitted parameters before and after the change, each in its own unit.
std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after);

/// Returns a warning if the reduction of chi2 is explained by chance or is little beside the misfit
/// that remains, or if the effect makes the prediction of left-out conditions worse. Then follows a
/// sentence for each fitted parameter that changed by more than three times the larger of its
/// standard errors before and after.
std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after);

/// Returns the command to run after the change: `pendular drop` for an added effect whose reduction
/// of chi2 chance explains or with which left-out conditions are predicted worse, `pendular
/// compare` for a fit that nothing speaks against, otherwise `pendular diagnose`.
/// @param believable whether nothing speaks against the fit after the change
/// @param study the study's name as the user gave it
std::string next_after(const StudyChange& change, const LadderStep& before, const LadderStep& after,
                       bool believable, const std::string& study);

/// Returns a sentence on the result of a change: chi2 per degree of freedom and the relative RMS
/// error of shear stress before and after it or, if the fit did not converge, that the study is
/// unchanged.
std::string answer_on(const ChangedStudy& changed);

/// Returns what `pendular add` and `pendular drop` say: the sentence on the result, then errors and
/// parameters before and after the change.
Output change_output(const ChangedStudy& changed);

}  // namespace pendular
