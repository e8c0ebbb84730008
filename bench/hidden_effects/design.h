#pragma once

#include <vector>

#include "bench/hidden_effects/truth.h"

namespace pendular::bench {

/// Chooses the hidden truths of the benchmark's virtual laboratories. They are the complete model,
/// single effects of the catalogue, pairs of effects, and effects outside the catalogue. An effect
/// gets one size for each of `noncentralities` (expected reduction of chi2 when the effect is added
/// to the model) that its bounds permit; an effect outside the catalogue gets only the size for the
/// last one. The emulator is used only to choose these sizes; the measurements come from
/// simulations.
std::vector<Truth> planned_truths(const std::vector<double>& noncentralities);

/// Returns hidden truths with the effects of `more_outside_effects`, one for each effect and each
/// of `noncentralities`. A noncentrality is the part of the change of chi2 by the effect that
/// neither the calibrated parameters nor two effects of the catalogue can imitate [1].
std::vector<Truth> planned_outside_truths(const std::vector<double>& noncentralities);

}  // namespace pendular::bench
