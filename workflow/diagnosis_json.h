#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/diagnosis/repeated.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// Names of the candidate effects that an explanation (refitted model) adds to the study's model.
std::vector<std::string> names_of(const Explanation& explanation, const ModelSpace& space);

/// JSON of a diagnosis, which `pendular diagnose` prints and writes to out/diagnosis.json.
/// @param checks tests of the residuals of the study's model without further effects
nlohmann::ordered_json to_json(const Diagnosis& diagnosis, const ModelSpace& space,
                               const Evidence& evidence, const Checks& checks);

/// JSON of the number of repetitions of the experiment with the same verdict; null without any.
nlohmann::ordered_json to_json(const std::optional<Repeated>& repeated);

}  // namespace pendular
