#pragma once

#include "calib/emulator/basis.h"
#include "data/study/study.h"
#include "sim/catalogue/effective_condition.h"
#include "sim/dem/run.h"
#include "sim/runs/fidelity.h"

namespace pendular {

/// 1/P* of a wet condition [1], with the liquid as changed by effects.
double inverse_pressure_of(const EffectiveCondition& condition, const Study& study);

/// Run of a study's grains at a state, without a seed; over the fidelity's strain.
dem::RunParameters run_at(const FlowState& state, const Study& study, const Fidelity& fidelity);

/// Share of the rigidity shift of runs of a stiffness number that separates them from the grains of
/// the study at a condition [1]; from those of the fidelity, where the study names no modulus.
double stiffness_share(double simulated, const Condition& condition, const GrainProperties& grains,
                       const Fidelity& fidelity);

}  // namespace pendular
