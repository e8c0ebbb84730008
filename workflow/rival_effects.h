#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/ladder.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Names of the effects that a study lists, in the order of the list.
std::vector<std::string> names_of(const std::vector<ListedEffect>& effects);

/// Reads the alternatives to an effect from the result of an earlier diagnosis: the sets of effects
/// that explained the readings equally well without the effect. Empty where `file`, a
/// diagnosis.json, does not exist or cannot be read, where no set that contains the effect
/// explained the readings, and where the study's list of effects has changed since the diagnosis.
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

/// Text on rival models, in which other effects replace one that the study lists and which the
/// readings do not rule out: their effects, their chi2, and how these effects can be measured
/// directly. Empty where `rivals` is empty.
/// @param chi2 chi2 of the study's model [1]
std::string rivals_line(const std::vector<RivalModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue);

/// JSON array of rival models: for each, the listed effect that it lacks, the effects that it has
/// instead, and its chi2 [1].
nlohmann::ordered_json to_json(const std::vector<RivalModel>& rivals);

}  // namespace pendular
