#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// Returns the names of the effects that a refitted model, `explanation`, has in addition to the
/// effects of the study's model.
/// @param space models to which the refitted model belongs, with the names of all candidate effects
///        (effects that may be added)
std::vector<std::string> names_of(const Explanation& explanation, const ModelSpace& space);

/// Returns the JSON of a diagnosis (search for effects that a study's model lacks): the verdict,
/// the effects that the verdict names, the test of each candidate effect, and the refitted models.
/// This JSON is the main part of out/diagnosis.json.
/// @param space models that were diagnosed, with the candidate effects (effects that may be added)
/// @param evidence readings that were diagnosed, with the suspect measurements (parts of the
///        measurement that may be wrong)
/// @param checks tests of the residuals of the study's model without further effects
nlohmann::ordered_json to_json(const Diagnosis& diagnosis, const ModelSpace& space,
                               const Evidence& evidence, const Checks& checks);

}  // namespace pendular
