#pragma once

#include <string>
#include <vector>

#include "workflow/study_change.h"

namespace pendular {

/// The change in one line: the error before and after.
std::string verdict_of(const StudyChange& change, const LadderStep& before, const LadderStep& after);

/// Errors before and after the change: chi2/dof, RMS errors [%] and those at conditions left out of
/// the fit.
std::vector<std::string> error_changes(const LadderStep& before, const LadderStep& after);

/// Parameters before and after the change, with the change in standard errors.
std::vector<std::string> parameter_changes(const LadderStep& before, const LadderStep& after);

/// Whether the change served, where it did not, and what to do then; `study` as the user names it.
std::vector<std::string> advice_on(const StudyChange& change, const LadderStep& before, const LadderStep& after,
                                   const std::string& study);

}  // namespace pendular
