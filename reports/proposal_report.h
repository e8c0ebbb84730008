#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/propose.h"

namespace pendular {

/// Sentence that states a fitted change of unknown cause, without a full stop: "The shown torque is
/// 9.8 +- 0.4 % larger than in the model where the time is above 12 s".
std::string sentence_on(const FittedShape& shape);
/// Sentence that states the changes of a proposal, joined by "and", without a full stop.
std::string sentence_on(const Proposal& proposal);

/// Lines for a diagnosis on the changes that would explain the readings, the best with the
/// reduction of chi2 that it brings; empty where there are none. `chi2` and `dof` are those of the
/// model without these changes.
std::vector<std::string> proposal_lines(const std::vector<Proposal>& proposals, double chi2,
                                        int dof);

}  // namespace pendular
