#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/propose.h"

namespace pendular {

/// Sentence, without a full stop, that states one fitted change of the readings of unknown physical
/// cause: "The shown torque is 9.8 +- 0.4 % larger than in the model where the time is above 12 s".
std::string sentence_on(const FittedShape& shape);
/// Sentence, without a full stop, that states all changes of one proposal, joined by "and". A
/// proposal is a set of changes of the readings, of unknown physical cause, that would explain the
/// misfit.
std::string sentence_on(const Proposal& proposal);

/// Lines of text on changes of unknown physical cause that would explain the readings, one set of
/// changes per proposal. For the best proposal, the lines also state by how much it reduces chi2.
/// Empty where `proposals` is empty.
/// @param chi2 chi2 of the model without the changes [1]
/// @param dof degrees of freedom of `chi2`
std::vector<std::string> proposal_lines(const std::vector<Proposal>& proposals, double chi2,
                                        int dof);

}  // namespace pendular
