#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "data/reading.h"
#include "sim/dem/grain_effects.h"
#include "sim/dem/run.h"

namespace pendular {

/// Returns the effects on grains in the form that the solver calls, from their names and their
/// values in the units of the run. Effects at their neutral values are omitted. `wet`: whether the
/// run has liquid bridges.
/// @throws std::invalid_argument for an effect that is unknown or does not act on grains, a value
///         outside of its bounds, and an effect on bridges in a dry run
dem::GrainEffects grain_effects(const std::vector<EffectValues>& effects, bool wet);

/// Returns the effects of a run as text:
///     rolling-resistance.coefficient=0.1 willett-bridges.on=1
std::string effects_text(const std::vector<EffectValues>& effects);
/// Returns the effects, sorted by name, that a text of `effects_text` describes.
/// @throws std::invalid_argument for a text of another form or with an unknown name
std::vector<EffectValues> effects_from(const std::string& text);

/// Checks that a run, with its effects, can be simulated.
/// @throws std::invalid_argument where it cannot, naming the parameter that is out of range
void check_run(const dem::RunParameters& run);

/// Returns a text that identifies a run: a line "name = value" for each parameter, with numbers in
/// their shortest exact form. It includes the number of threads, which changes the rounding.
std::string run_description(const dem::RunParameters& run, int threads = 1);

/// Returns the 64-bit FNV-1a hash of a text; that of `run_description` identifies a run.
std::uint64_t fingerprint(std::string_view text);

/// Carries out a run with the effects that it names, and sets `options.description` for dem::run.
/// @throws whatever `grain_effects` and dem::run throw
dem::RunResult simulate(const dem::RunParameters& run, dem::RunOptions options = {});

}  // namespace pendular
