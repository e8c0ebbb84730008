#pragma once

#include <memory>
#include <vector>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/terms.h"

namespace pendular {

/// The model of a study: the base that it names (for `rumpf` with the terms that closure effects
/// make of it) on a simulation, and effects on top. Without effects it predicts bit for bit what
/// the base does.
/// @param effects in the order of their parameters; must outlive the model
std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects);

/// Terms of a closure that these effects switch on.
closures::Terms terms_of(const std::vector<const Effect*>& effects);

}  // namespace pendular
