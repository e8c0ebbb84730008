#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/ladder.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Names of listed effects, in the order of the list.
std::vector<std::string> names_of(const std::vector<ListedEffect>& effects);

/// Alternatives to an effect according to an earlier diagnosis: sets of effects that do not contain
/// the effect and that explained the readings as well. Empty where `file`, a diagnosis.json, does
/// not exist or cannot be read, and where it is of a model with other effects than the study lists.
std::vector<std::vector<std::string>> rivals_in(const std::filesystem::path& file,
                                                const Study& study, const std::string& effect);

/// Fits the models in which one effect that the study lists is replaced by an alternative to it, a
/// set of effects that explained the readings equally well when the effect was added
/// (`LadderStep::rivals`). Returns the models that the readings do not rule out: their chi2 + 2
/// (number of parameters), Akaike's criterion, exceeds that of the study's model by less than 7.
/// Other effects that the study lists stay in the model.
/// @param diagnosis diagnosis of the study, whose readings and emulator are used
/// @param ladder sequence of the study's models, with the alternatives to each added effect
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), section 2.6.
std::vector<RivalModel> rivals_alive(const StudyDiagnosis& diagnosis, const ResolvedStudy& study,
                                     const Ladder& ladder);

/// Sentence on rival models that the readings do not rule out, with how to measure the effects
/// directly; empty without rivals. `chi2` is that of the study's model [1].
std::string rivals_line(const std::vector<RivalModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue);

/// JSON array with the listed effect, the effects in its place and the chi2 of each rival model.
nlohmann::ordered_json to_json(const std::vector<RivalModel>& rivals);

}  // namespace pendular
