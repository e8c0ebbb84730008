#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/diagnosis/repeated.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// Names of the effects that a refitted model (`explanation`) has in addition to the effects of the
/// study's model.
/// @param space models to which the refitted model belongs, with the names of all candidate effects
std::vector<std::string> names_of(const Explanation& explanation, const ModelSpace& space);

/// JSON of a diagnosis, as in out/diagnosis.json: the verdict, the effects that it names, the test
/// of each candidate effect, and the refitted models.
/// @param space models that were diagnosed, with the candidate effects
/// @param evidence readings that were diagnosed, with the measurements suspected of errors
/// @param checks tests of the residuals of the study's model without further effects
nlohmann::ordered_json to_json(const Diagnosis& diagnosis, const ModelSpace& space,
                               const Evidence& evidence, const Checks& checks);

/// JSON with the number of simulated repetitions of the experiment (`of`) and the number of
/// repetitions that give the same verdict as the readings (`same`). Null where no repetitions were
/// simulated.
nlohmann::ordered_json to_json(const std::optional<Repeated>& repeated);

}  // namespace pendular
