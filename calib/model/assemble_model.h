#pragma once

#include <memory>
#include <vector>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/level.h"

namespace pendular {

/// Assembles the model of a study: the emulated `simulation`, or the formula for wet grains of the
/// level of the ladder of closures that the base model and the effects reach (`level_with`), with
/// effects added. Without effects the model predicts exactly what the base predicts.
/// @param effects in the order of their parameters; must outlive the model
/// @throws InputError where the level is `mohr_coulomb` and the study has no strengths to fit
///         cohesions to (`MohrCoulombModel`)
std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects);

/// Highest level of the ladder of closures among the base model of a study and these effects.
closures::Level level_with(const Study& study, const std::vector<const Effect*>& effects);

}  // namespace pendular
