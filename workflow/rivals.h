#pragma once

#include <vector>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the rival models in which a quantity, such as the stress ratio, changes by an unknown
/// cause: one for each proposal of the diagnosis, then one refitted model for each change that
/// would alter the readings in nearly the same way as the first proposal (`Proposal::alike`).
///
/// Left out are changes of a quantity that a sensor shows, since a check of the sensor settles
/// them, and models whose Akaike criterion exceeds the smallest one by `ruled_out` or more.
std::vector<Rival> proposal_rivals(const StudyDiagnosis& diagnosis);

/// Returns the rival models, which the next measurement should tell apart: the models that fit the
/// readings according to a diagnosis or, if none fits, the first of the following that exists:
/// - the model with the leading effects;
/// - the models with proposed changes of unknown cause (`proposal_rivals`);
/// - the study's model.
/// If this gives only one model, `StudyDiagnosis::rivals` are added.
std::vector<Rival> rivals_of(const StudyDiagnosis& diagnosis);

}  // namespace pendular
