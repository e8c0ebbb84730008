#pragma once

#include <memory>
#include <vector>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/level.h"

namespace pendular {

/// Returns the model that predicts the shear stress [Pa] and solid fraction [1] of a study's
/// readings. `simulation` predicts dry grains. For wet grains, `level_with` selects `simulation` or
/// an analytical formula (closure) for the stress ratio. The physical effects `effects` change the
/// predictions.
/// @param simulation predictor that uses an emulator (Gaussian processes trained on simulations)
/// @param effects effects of the model, in the order of their parameters; the effects must outlive
///        the model
/// @throws InputError if `level_with` returns `closures::Level::mohr_coulomb` (constant cohesions)
///         but the study has no wet reading of steady shear at a reduced pressure of at least 2.3
std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects);

/// Selects the analytical formula (closure) or the simulation with which a model predicts the
/// stress ratio of wet grains. The levels `closures::Level` are ordered from the simplest formula
/// to the simulation. The study's base model (the model without effects) has a level, and so has
/// each effect that replaces an approximation of the formula. The function returns the highest
/// level of the base model and the effects.
closures::Level level_with(const Study& study, const std::vector<const Effect*>& effects);

}  // namespace pendular
