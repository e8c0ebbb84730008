#pragma once

#include <vector>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the models with the changes of unknown cause that a diagnosis proposes, as rival models
/// that the next measurement should tell apart. The list contains one model for each proposal, then
/// one model for each change that would alter the readings in nearly the same way as the first
/// proposal (`Proposal::alike`), refitted to the readings. Left out are models with a change of
/// what a sensor shows, which a check of the sensor settles, and models that the readings rule out:
/// their Akaike criterion exceeds the smallest criterion by `little_support` or more. Empty if
/// nothing is left.
std::vector<Rival> proposal_rivals(const StudyDiagnosis& diagnosis);

/// Returns the rival models, which the next measurement should tell apart: the models that fit the
/// readings according to a diagnosis. If no model fits, the function returns the model with the
/// leading effects (effects that explain most of the misfit), else the models with proposed changes
/// of unknown cause (`proposal_rivals`), else the study's model. If this gives only one model, the
/// function also returns the models in which other effects replace one effect that the study lists
/// (`StudyDiagnosis::rivals`).
std::vector<Rival> rivals_of(const StudyDiagnosis& diagnosis);

}  // namespace pendular
