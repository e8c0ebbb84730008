#pragma once

#include <string>
#include <vector>

#include "workflow/study_change.h"

namespace pendular {

/// Returns a sentence on a change of the study's model, one effect added or dropped: chi2/dof and
/// the RMS error of the shear stress [%] before and after.
std::string verdict_of(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after);

/// Table of the model's errors before and after a change: chi2/dof, RMS errors [%], and RMS errors
/// at conditions that were left out of the fit [%].
std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after);

/// Table of the fitted parameters before and after a change. The change of a parameter is given in
/// units of its standard error before.
std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after);

/// Advice after a change, as sentences: on an added effect that does not improve the model, on a
/// dropped effect, and on parameters that changed by more than three standard errors. `study` is
/// the study's name as the user gave it, for commands in the text.
std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after, const std::string& study);

}  // namespace pendular
