#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "analysis/ladder.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the rival models in which a quantity, such as the stress ratio, changes by an unknown
/// cause: one for each proposal of the diagnosis, then one refitted model for each change that
/// would alter the readings in nearly the same way as the first proposal (`Proposal::alike`).
///
/// Left out are changes of a quantity that a sensor shows, since a check of the sensor settles
/// them, and models whose Akaike criterion exceeds the smallest one by `ruled_out` or more.
std::vector<FittedModel> proposal_rivals(const StudyDiagnosis& diagnosis);

/// Returns the rival models, which the next measurement should tell apart: the models that fit the
/// readings according to a diagnosis or, if none fits, the first of the following that exists:
/// - the model with the leading effects;
/// - the models with proposed changes of unknown cause (`proposal_rivals`);
/// - the study's model.
/// If this gives only one model, `StudyDiagnosis::rivals` are added.
std::vector<FittedModel> rivals_of(const StudyDiagnosis& diagnosis);

/// Fits the models in which an alternative (`LadderStep::rivals`) replaces one effect that the
/// study lists, and returns those that the readings do not rule out: their `akaike` criterion
/// exceeds that of the study's model by less than `ruled_out`.
std::vector<FittedModel> rivals_not_ruled_out(const StudyDiagnosis& diagnosis,
                                              const ResolvedStudy& study, const Ladder& ladder);

/// Returns the alternatives to an effect among sets of effects that explain the readings: the sets
/// without `effect`; none if no set contains it.
EffectNames rivals_among(const EffectNames& sets, const std::string& effect);
/// Returns the sets of effects that explain the readings according to a diagnosis.
EffectNames explaining_sets(const StudyDiagnosis& diagnosis);

/// Returns the names of the effects that a study lists, in the order of the list.
std::vector<std::string> names_of(const std::vector<ListedEffect>& effects);

}  // namespace pendular
