#pragma once

#include <optional>
#include <string>
#include <vector>

#include "data/reading.h"
#include "data/study/study.h"

namespace pendular {

/// Returns a note for the user if the weight of the grains, divided by the area of the cell,
/// exceeds 10 % of the normal stress in at least one reading (mean over a step of steady shear).
/// The model of the study neglects the weight, which raises the normal stress at the base of the
/// sample. The result is empty if no reading exceeds 10 %, if the study has no cell, or if the
/// model has the effect grain-weight.
std::optional<std::string> grain_weight_note(const Study& study,
                                             const std::vector<Reading>& readings);

}  // namespace pendular
