#pragma once

#include <vector>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the rival models in which a quantity, such as the stress ratio, changes by an unknown
/// cause. The next measurement should tell these models apart. First comes one model for each
/// proposal of the diagnosis (one or two changes that would explain the misfit). Then follows one
/// refitted model for each change that would alter the readings in nearly the same way as the first
/// proposal (`Proposal::alike`).
///
/// The list leaves out models with a change of a quantity that a sensor shows, since a check of the
/// sensor settles such a change. A model is also left out if its Akaike criterion exceeds the
/// smallest Akaike criterion in the list by `ruled_out` or more. Empty if no model is left.
std::vector<Rival> proposal_rivals(const StudyDiagnosis& diagnosis);

/// Returns the rival models, which the next measurement should tell apart: the models that fit the
/// readings according to a diagnosis. If no model fits, the result is the first of the following
/// that exists:
/// - the model with the leading effects (effects that explain most of the misfit);
/// - the models with proposed changes of unknown cause (`proposal_rivals`);
/// - the study's model.
/// If this gives only one model, `StudyDiagnosis::rivals` are added: models with other effects in
/// place of one effect that the study lists.
std::vector<Rival> rivals_of(const StudyDiagnosis& diagnosis);

}  // namespace pendular
