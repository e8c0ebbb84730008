#pragma once

#include <memory>
#include <vector>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/terms.h"

namespace pendular {

/// Assembles the model of a study: its base model (the emulated `simulation`, or the closure
/// formula `rumpf` that uses it) with effects added. With base `rumpf`, closure effects switch on
/// terms of the formula. Without effects the predictions are exactly those of the base model.
/// @param effects in the order of their parameters; must outlive the model
std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects);

/// Optional terms that these effects switch on in the closure (formula for the shear stress of wet
/// grains) of the base model `rumpf`.
closures::Terms terms_of(const std::vector<const Effect*>& effects);

}  // namespace pendular
