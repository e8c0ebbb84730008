#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// A note that names the files and normal stresses of recordings in which the weight of the grains,
/// M g/A, exceeds 10 % of the normal stress, since shear gathers under the lid there; empty where
/// there are none and where the study lists the effect grain-weight.
std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings);

}  // namespace pendular
