#pragma once

#include "calib/emulator/basis.h"
#include "data/study/study.h"
#include "sim/catalogue/effective_condition.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Inverse reduced pressure 1/P* = F0/(a^2 s22) of a wet condition [1], with the grain diameter a,
/// the normal stress s22 and the pull-off force F0 of a liquid bridge. F0 is that of the
/// condition's liquid, which effects may have changed, or else of the study's liquid.
/// @throws std::bad_optional_access if neither the condition nor the study has a liquid
double inverse_pressure_of(const EffectiveCondition& condition, const Study& study);

/// Returns the parameters of a simulation run (discrete-element method) of the study's grains at a
/// state of steady shear. Number of grains, stiffness number and strain are those of the settings
/// `fidelity`. The seed has its default value.
dem::RunParameters run_at(const FlowState& state, const Study& study, const Fidelity& fidelity);

/// Stiffness number kappa = (E/((1 - nu^2) s22))^(2/3) of the study's `grains` at the normal stress
/// s22 of a condition [1]; E: Young's modulus, nu: Poisson ratio. If the study states no Young's
/// modulus, the stiffness number in the simulation settings `fidelity` is returned.
double stiffness_number_of(const Condition& condition, const GrainProperties& grains,
                           const Fidelity& fidelity);

/// Difference of solid fraction between the study's grains and grains of the stiffness number
/// `simulated`, divided by the same difference for rigid grains [1]. With the study's stiffness
/// number kappa (`stiffness_number_of`), it is
///     1 - simulated/kappa,
/// negative if the study's grains are softer than those simulated.
double stiffness_share(double simulated, const Condition& condition, const GrainProperties& grains,
                       const Fidelity& fidelity);

}  // namespace pendular
