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

/// Returns the effects on grains of a run, with their parameter values in reduced units, as text:
///     rolling-resistance.coefficient=0.1 willett-bridges.on=1
std::string effects_text(const std::vector<EffectValues>& effects);
/// Returns the effects on grains and their parameter values, sorted by effect name, that a text in
/// the form of `effects_text` describes: the inverse of `effects_text`.
/// @throws std::invalid_argument for a text of another form or with an unknown name
std::vector<EffectValues> effects_from(const std::string& text);

/// Checks, before any work, that a run with its effects on grains can be simulated.
/// @throws std::invalid_argument for a parameter that is out of range, naming it, and for effects
///         that `grain_effects` does not accept
void check_run(const dem::RunParameters& run);

/// Returns a text that identifies a simulation run: lines "name = value" for its parameters, with
/// numbers in their shortest exact form. The number of threads is included, since it changes the
/// rounding of the results.
std::string run_description(const dem::RunParameters& run, int threads = 1);

/// Returns the 64-bit FNV-1a hash of a text. The hash of `run_description` identifies a run.
std::uint64_t fingerprint(std::string_view text);

/// Simulates a run with the effects on grains that `run.effects` names, and returns its time
/// averages. `options.description` is overwritten with the run's `run_description`.
/// @throws whatever `grain_effects` and dem::run throw
dem::RunResult simulate(const dem::RunParameters& run, dem::RunOptions options = {});

}  // namespace pendular
