#pragma once

#include <memory>
#include <vector>

#include "calib/model/effect_model.h"
#include "calib/model/emulated_simulation.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/closures/level.h"

namespace pendular {

/// Returns the model of a study's readings: `simulation`, with the formula of `level_with` for the
/// stress ratio of wet grains, and with `effects`.
/// @param effects in the order of their parameters; must outlive the model
/// @throws InputError if the level is `closures::Level::mohr_coulomb` but the study has no wet
///         reading of steady shear at a reduced pressure of at least 2.3
std::shared_ptr<const EffectModel> assemble_model(
    const Study& study, std::shared_ptr<const EmulatedSimulation> simulation,
    const std::vector<const Effect*>& effects);

/// Returns the formula (or the simulation) for the stress ratio of wet grains: the highest level of
/// the study's base model and of the effects that replace approximations.
closures::Level level_with(const Study& study, const std::vector<const Effect*>& effects);

}  // namespace pendular
