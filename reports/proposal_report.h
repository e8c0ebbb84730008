#pragma once

#include <string>
#include <vector>

#include "analysis/proposals/propose.h"

namespace pendular {

/// Returns the end of a sentence, without a full stop, on a fitted change of unknown cause: "the
/// shown torque is 9.80 +- 0.40 % larger than in the model where the time since the first recording
/// began is above 12 s, and agrees elsewhere".
/// @param reference words for the values with which the changed values are compared
std::string phrase_on(const FittedShape& shape, const std::string& reference = "in the model");

/// Returns `phrase_on` with a capital, without a full stop.
std::string sentence_on(const FittedShape& shape);

/// Returns a sentence for each change of a proposal, without a full stop at the end.
std::string sentence_on(const Proposal& proposal);

/// Returns lines on proposals, the best first, with chi2/dof without and with the changes of the
/// best. Empty if `proposals` is empty.
/// @param chi2 chi2 of the model without the changes [1]
/// @param dof degrees of freedom of `chi2`
std::vector<std::string> proposal_lines(const std::vector<Proposal>& proposals, double chi2,
                                        int dof);

}  // namespace pendular
