#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Note on recordings in which the weight of the grains per area, M g/A, exceeds 10 % of the normal
/// stress, so that shear may localize under the lid; it names files and normal stresses. Empty if
/// there are no such recordings, or if the study's model has the effect grain-weight.
std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings);

}  // namespace pendular
