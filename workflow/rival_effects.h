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

/// Reads the alternatives to an effect from the result of an earlier diagnosis: sets of effects
/// without `effect` that explained the readings as well as the sets with it. Empty if `file` (a
/// diagnosis.json) cannot be read, if no set with `effect` explained the readings, or if the
/// study's list of effects has changed since the diagnosis.
std::vector<std::vector<std::string>> rivals_in(const std::filesystem::path& file,
                                                const Study& study, const std::string& effect);

/// Fits the models in which an alternative (`LadderStep::rivals`) replaces one effect that the
/// study lists, and returns those that the readings do not rule out: Akaike's criterion, chi2 + 2
/// (number of parameters), exceeds that of the study's model by less than 7.
/// Source: Burnham and Anderson, Model Selection and Multimodel Inference (2002), section 2.6.
std::vector<RivalModel> rivals_not_ruled_out(const StudyDiagnosis& diagnosis,
                                             const ResolvedStudy& study, const Ladder& ladder);

/// Returns a text for the user on rival models: their effects, their chi2 [1], and how the effects
/// can be measured directly. Empty if there are none.
/// @param chi2 chi2 of the study's model [1]
std::string rivals_line(const std::vector<RivalModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue);

/// Returns a text on how each effect can be measured directly, such as "contact-angle by ...;
/// torque-gain by ...". Effects without a direct measurement are left out.
std::string direct_methods(const std::vector<std::string>& effects,
                           const EffectCatalogue& catalogue);

/// Returns a JSON array of rival models: the listed effect that each lacks, its effects instead,
/// and its chi2 [1].
nlohmann::ordered_json to_json(const std::vector<RivalModel>& rivals);

}  // namespace pendular
