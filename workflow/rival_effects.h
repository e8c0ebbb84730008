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

/// Rivals of an effect according to an earlier diagnosis: each a set of effects that explained the
/// readings as well as the effect, and does not contain it. Empty where `file`, a diagnosis.json,
/// does not exist or cannot be read, and where it is of a model with other effects than the study
/// lists.
std::vector<std::vector<std::string>> rivals_in(const std::filesystem::path& file,
                                                const Study& study, const std::string& effect);

/// Fits the rivals of the effects that a study lists, as its ladder keeps them, and returns the
/// models that the readings do not rule out: chi2 + 2 (number of parameters), Akaike's criterion,
/// exceeds that of the study's model by less than 7. Larger differences leave a model little
/// support. Effects of a rival that the study lists by now stay in the model.
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
