#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns a note if the weight of the grains over the area of the cell, which raises the normal
/// stress at the base of the sample, exceeds 10 % of the normal stress in at least one reading
/// whose step is known. Empty otherwise, without a cell, and if the model has the effect
/// grain-weight.
std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings);

}  // namespace pendular
