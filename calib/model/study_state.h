#pragma once

#include "calib/emulator/basis.h"
#include "data/study/study.h"
#include "sim/catalogue/effect.h"
#include "sim/dem/run.h"
#include "sim/runs/run_settings.h"

namespace pendular {

/// Returns the inverse reduced pressure 1/P* = F0/(a^2 s22) of a wet condition [1]. F0 is that of
/// the condition's own liquid, which effects may have changed, or else of the study's liquid.
/// @throws std::bad_optional_access if neither the condition nor the study has a liquid
double inverse_pressure_of(const EffectiveCondition& condition, const Study& study);

/// Returns the parameters of a run of the study's grains at a state of steady shear. The number of
/// grains, the stiffness number and the strain are those of `fidelity`, the seed is the default.
dem::RunParameters run_at(const FlowState& state, const Study& study, const Fidelity& fidelity);

/// Returns the stiffness number kappa = (E/((1 - nu^2) s22))^(2/3) [1] of the study's `grains` at
/// the normal stress of a condition, or that of `fidelity` if the study states no Young's modulus.
double stiffness_number_of(const Condition& condition, const GrainProperties& grains,
                           const Fidelity& fidelity);

/// Returns the fraction [1] of the correction to rigid grains that converts the solid fraction of
/// simulated grains to that of the study's grains at a condition:
///     (phi_study - phi_simulated)/(phi_rigid - phi_simulated) = 1 - simulated/kappa,
/// with the study's stiffness number kappa (`stiffness_number_of`). The fraction is negative if the
/// study's grains are softer than the simulated ones.
/// @param simulated stiffness number of the simulated grains [1]
double stiffness_share(double simulated, const Condition& condition, const GrainProperties& grains,
                       const Fidelity& fidelity);

}  // namespace pendular
