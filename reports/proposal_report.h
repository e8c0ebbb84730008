#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/propose.h"

namespace pendular {

/// Sentence, without a full stop, that states one fitted change of unknown cause: "The shown torque
/// is 9.8 +- 0.4 % larger than in the model where the time is above 12 s".
std::string sentence_on(const FittedShape& shape);
/// Sentence, without a full stop, that states the changes of one proposal, joined by "and".
std::string sentence_on(const Proposal& proposal);

/// Lines of text on the changes of unknown cause that would explain the readings. For the best
/// proposal, they state the reduction of chi2 that it brings. Empty where there are none.
/// @param chi2 chi2 of the model without the changes [1]
/// @param dof degrees of freedom of `chi2`
std::vector<std::string> proposal_lines(const std::vector<Proposal>& proposals, double chi2,
                                        int dof);

}  // namespace pendular
