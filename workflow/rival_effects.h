#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/ladder.h"
#include "sim/catalogue/resolved_study.h"
#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the names of the effects that a study lists, in the order of the list.
std::vector<std::string> names_of(const std::vector<ListedEffect>& effects);

/// Reads the alternatives to an effect from the result of an earlier diagnosis. An alternative is a
/// set of effects without `effect` that explained the readings as well as the sets with `effect`.
/// Empty if `file` (a diagnosis.json) cannot be read, if no set with `effect` explained the
/// readings, or if the study's list of effects has changed since the diagnosis.
std::vector<std::vector<std::string>> rivals_in(const std::filesystem::path& file,
                                                const Study& study, const std::string& effect);

/// Fits the models in which an alternative replaces one effect that the study lists, and returns
/// the models that the readings do not rule out. An alternative is a set of effects that explained
/// the readings equally well when the listed effect was added (`LadderStep::rivals`). The readings
/// rule out a model if Akaike's criterion, chi2 + 2 (number of parameters), exceeds the criterion
/// of the study's model by 7 or more.
/// @param diagnosis diagnosis of the study, whose readings and emulator are used
/// @param ladder sequence of the study's models, with the alternatives to each added effect
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), section 2.6.
std::vector<RivalModel> rivals_not_ruled_out(const StudyDiagnosis& diagnosis,
                                             const ResolvedStudy& study, const Ladder& ladder);

/// Returns a text for the user on rival models. In a rival model, other effects replace one effect
/// that the study lists. The text states the effects and the chi2 [1] of each rival model, and how
/// the effects can be measured directly. Empty if `rivals` is empty.
/// @param chi2 chi2 of the study's model [1]
std::string rivals_line(const std::vector<RivalModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue);

/// Returns a text that states how each effect can be measured directly, without shearing grains,
/// such as "contact-angle by ...; torque-gain by ...". Effects that cannot be measured directly are
/// left out. Empty if no effect can be measured directly.
/// @param effects names of effects
std::string direct_methods(const std::vector<std::string>& effects,
                           const EffectCatalogue& catalogue);

/// Returns a JSON array of rival models, in which other effects replace one effect that the study
/// lists. Each object contains the listed effect that the model lacks, the effects that the model
/// has instead, and the chi2 of the model [1].
nlohmann::ordered_json to_json(const std::vector<RivalModel>& rivals);

}  // namespace pendular
