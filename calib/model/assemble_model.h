#pragma once

#include <memory>
#include <vector>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/terms.h"

namespace pendular {

/// Assembles the model of a study: the base that the study names, computed from `simulation`, with
/// effects added. In base `rumpf`, closure effects switch on terms of the closure. Without effects
/// the model predicts exactly what the base predicts.
/// @param effects in the order of their parameters; must outlive the model
std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects);

/// Terms that these effects switch on in the closure of the base model `rumpf`.
closures::Terms terms_of(const std::vector<const Effect*>& effects);

}  // namespace pendular
