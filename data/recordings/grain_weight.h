#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Note on readings of recordings in which the weight of the grains per area exceeds 10 % of the
/// normal stress, so that shear may localize under the lid; it names files and normal stresses.
/// Empty if there are no such readings, if the study has no cell, or if the study's model has the
/// effect grain-weight.
std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings);

}  // namespace pendular
