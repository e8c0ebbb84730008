#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/propose.h"

namespace pendular {

/// Returns the end of a sentence, without a full stop, that states one fitted change of the
/// readings, of unknown physical cause: "the shown torque is 9.80 +- 0.40 % larger than in the
/// model where the time since the first recording began is above 12 s, and agrees elsewhere".
/// @param reference words for the values with which the changed values are compared
std::string phrase_on(const FittedShape& shape, const std::string& reference = "in the model");

/// Returns a sentence, without a full stop, that states one fitted change of the readings, of
/// unknown physical cause: "The shown torque is 9.80 +- 0.40 % larger than in the model where the
/// time since the first recording began is above 12 s, and agrees elsewhere".
std::string sentence_on(const FittedShape& shape);

/// Returns one sentence for each change of a proposal, as one text without a full stop at the end.
/// A proposal is a set of changes of the readings, of unknown physical cause, that would explain
/// the misfit.
std::string sentence_on(const Proposal& proposal);

/// Returns lines of text on proposals, the best proposal first. A proposal is a set of changes of
/// the readings, of unknown physical cause, that would explain the misfit or most of it. For the
/// best proposal, the lines also state chi2 per degree of freedom without and with the changes.
/// Returns an empty list if `proposals` is empty.
/// @param chi2 chi2 of the model without the changes [1]
/// @param dof degrees of freedom of `chi2`
std::vector<std::string> proposal_lines(const std::vector<Proposal>& proposals, double chi2,
                                        int dof);

}  // namespace pendular
