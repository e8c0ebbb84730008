#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns a note for the user if the weight of the grains per area exceeds 10 % of the normal
/// stress in some readings that were averaged over a step. The weight then raises the normal stress
/// in the sample. The result is empty if no reading exceeds 10 %, if the study has no cell, or if
/// the model of the study has the effect grain-weight.
std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings);

}  // namespace pendular
