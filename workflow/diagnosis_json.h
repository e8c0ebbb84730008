#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "analysis/diagnosis/diagnosis.h"
#include "analysis/misfit/checks.h"

namespace pendular {

/// The candidates that an explanation has in the model.
std::vector<std::string> names_of(const Explanation& explanation, const ModelSpace& space);

/// JSON that `diagnose` prints and `out/diagnosis.json` holds.
nlohmann::ordered_json to_json(const Diagnosis& diagnosis, const ModelSpace& space,
                               const Evidence& evidence, const Checks& checks);

}  // namespace pendular
