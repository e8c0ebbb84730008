#pragma once

#include "calib/emulator/basis.h"
#include "data/study/study.h"
#include "sim/catalogue/effective_condition.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// Inverse reduced pressure 1/P* of a wet condition [1], with the liquid as effects have changed
/// it.
double inverse_pressure_of(const EffectiveCondition& condition, const Study& study);

/// Parameters of a run that simulates a study's grains at a flow state, with the size, stiffness
/// number and strain of the fidelity. The seed is not set.
dem::RunParameters run_at(const FlowState& state, const Study& study, const Fidelity& fidelity);

/// Share of the rigidity shift (change of solid fraction from rigid to soft grains) by which grains
/// of stiffness number `simulated` differ from the study's grains at a condition [1]:
///     1 - simulated/kappa,
/// with kappa the stiffness number of the study's grains or, where the study states no Young's
/// modulus, the stiffness number of the fidelity.
double stiffness_share(double simulated, const Condition& condition, const GrainProperties& grains,
                       const Fidelity& fidelity);

}  // namespace pendular
