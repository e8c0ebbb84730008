#pragma once

#include "calib/emulator/basis.h"
#include "data/study/study.h"
#include "sim/catalogue/effective_condition.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Inverse reduced pressure 1/P* = F0/(a^2 s22) of a wet condition [1], with the pull-off force F0
/// of the condition's liquid as effects have changed it or, where none is set, of the study's
/// liquid.
/// @throws std::bad_optional_access where neither the condition nor the study has a liquid
double inverse_pressure_of(const EffectiveCondition& condition, const Study& study);

/// Parameters of a DEM run at a flow state of the study's grains, with number of grains, stiffness
/// number and strain of `fidelity` (set of simulation settings). The seed keeps its default.
dem::RunParameters run_at(const FlowState& state, const Study& study, const Fidelity& fidelity);

/// Stiffness number [1] of the study's `grains` at `condition` or, where the study states no
/// Young's modulus, of `fidelity` (set of simulation settings).
double stiffness_number_of(const Condition& condition, const GrainProperties& grains,
                           const Fidelity& fidelity);

/// Share of the rigidity shift (change of solid fraction from rigid to soft grains) at stiffness
/// number `simulated` that grains of stiffness number kappa do not have [1]:
///     1 - simulated/kappa,
/// with the stiffness number kappa that `stiffness_number_of` returns.
double stiffness_share(double simulated, const Condition& condition, const GrainProperties& grains,
                       const Fidelity& fidelity);

}  // namespace pendular
