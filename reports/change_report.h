#pragma once

#include <string>
#include <vector>

#include "workflow/study_change.h"

namespace pendular {

/// One line about the change: the error before and after.
std::string verdict_of(const StudyChange& change, const LadderStep& before,
                       const LadderStep& after);

/// Errors before and after the change: chi2/dof, RMS errors [%] and those at conditions left out of
/// the fit.
std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after);

/// Parameters before and after the change, with the change in standard errors.
std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after);

/// Sentences on whether the change improved the model, where it did not, and what to do next;
/// `study` as the user named it.
std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before,
                                   const LadderStep& after, const std::string& study);

}  // namespace pendular
