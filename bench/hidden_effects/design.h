#pragma once

#include <vector>

#include "bench/hidden_effects/truth.h"

namespace pendular::bench {

/// Chooses the hidden truths of the benchmark's virtual laboratories. The truths are the complete
/// model, single effects of the catalogue, pairs of effects, and effects outside the catalogue. A
/// single effect gets one truth for each of `noncentralities`, with the size of the effect that has
/// this noncentrality (`Truth::noncentrality`). If the bounds of the effect do not permit this
/// size, one truth has the size at the bound. An effect that is a switch (on or off) gets one
/// truth. An effect outside the catalogue gets one truth, with the last noncentrality. Truths with
/// a noncentrality below 5 are left out. An emulator (which interpolates simulations) predicts the
/// noncentralities; the measurements come from simulations.
std::vector<Truth> planned_truths(const std::vector<double>& noncentralities);

/// Returns hidden truths with the effects of `more_outside_effects`, one for each effect and each
/// of `noncentralities` [1] (`Truth::noncentrality`). If the bounds of an effect do not permit a
/// noncentrality, one truth has the size at the bound. Truths with a noncentrality below 5 are left
/// out.
std::vector<Truth> planned_outside_truths(const std::vector<double>& noncentralities);

}  // namespace pendular::bench
