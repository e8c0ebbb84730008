#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "workflow/study_diagnosis.h"

namespace pendular {

/// Returns the names of the effects that a study lists, in the order of the list.
std::vector<std::string> names_of(const std::vector<ListedEffect>& effects);

/// Returns a text for the user on rival models: their effects, their chi2 [1], and how the effects
/// can be measured directly. Empty if there are none.
/// @param chi2 chi2 of the study's model [1]
std::string rivals_line(const std::vector<FittedModel>& rivals, double chi2,
                        const EffectCatalogue& catalogue);

/// Returns a text on how each effect can be measured directly, such as "contact-angle by ...;
/// torque-gain by ...". Effects without a direct measurement are left out.
std::string direct_methods(const std::vector<std::string>& effects,
                           const EffectCatalogue& catalogue);

/// Returns a JSON array of rival models: the listed effect that each lacks, its effects instead,
/// and its chi2 [1].
nlohmann::ordered_json to_json(const std::vector<FittedModel>& rivals);

}  // namespace pendular
