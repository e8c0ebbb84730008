#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "data/reading.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/run.h"

namespace pendular {

/// Resolves effects by name, values in the units of the run, to what the solver calls; those at
/// their neutral value are left out.
/// @throws std::invalid_argument for an effect that is unknown or not one on grains, for values
///         beyond its bounds, and where one needs bridges and there are none
dem::GrainEffects grain_effects(const std::vector<EffectValues>& effects, bool wet);

/// Text of the effects of a run, as in "rolling-resistance.coefficient=0.1 willett-bridges.on=1",
/// and the effects of such a text.
/// @throws std::invalid_argument for any other text
std::string effects_text(const std::vector<EffectValues>& effects);
std::vector<EffectValues> effects_from(const std::string& text);

/// Refuses a run that cannot be simulated, effects included, before any work.
/// @throws std::invalid_argument naming the parameter that is out of range
void check_run(const dem::RunParameters& run);

/// Text that determines a run, one line "name = value" each, numbers in their shortest exact form.
/// Its threads are part of it: rounding differs.
std::string run_description(const dem::RunParameters& run, int threads = 1);

/// FNV-1a of a text; of `run_description` it tells runs apart.
std::uint64_t fingerprint(std::string_view text);

/// Carries a run out with the effects that it names: dem::run, and its errors.
dem::RunResult simulate(const dem::RunParameters& run, dem::RunOptions options = {});

}  // namespace pendular
