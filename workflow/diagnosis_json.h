#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// Returns the names of the effects that a refitted model has beyond those of the study's model.
std::vector<std::string> names_of(const FittedModel& explanation, const ModelSpace& space);

/// Returns the JSON of a diagnosis, the main part of out/diagnosis.json: the verdict with its
/// effects, the test of each candidate effect, and the refitted models.
/// @param checks tests of the residuals of the study's model without further effects
nlohmann::ordered_json to_json(const Diagnosis& diagnosis, const ModelSpace& space,
                               const Evidence& evidence, const Checks& checks);

}  // namespace pendular
