#pragma once

#include <vector>

#include "bench/hidden_effects/truth.h"

namespace pendular::bench {

/// Chooses what the laboratories hide: every effect that applies at the amplitudes that reach these
/// noncentralities, as far as its bounds allow, switches on; pairs of them; effects outside the
/// catalogue; and the complete model. By the emulator, which chooses sizes and nothing else: what
/// is measured comes from simulations.
std::vector<Truth> planned_truths(const std::vector<double>& noncentralities);

/// Chooses the sizes of the effects of `more_outside_effects` that reach these noncentralities.
std::vector<Truth> planned_outside_truths(const std::vector<double>& noncentralities);

}  // namespace pendular::bench
