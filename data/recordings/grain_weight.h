#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns a note for the user if the weight of the grains per area exceeds 10 % of the normal
/// stress in some readings of recordings, since shear may then localize under the lid. The note
/// names files and normal stresses. Empty if the weight is below 10 % in all readings, if the study
/// has no cell, or if its model already has the effect grain-weight.
std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings);

}  // namespace pendular
